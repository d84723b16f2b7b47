#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tools/log/comparison.hpp"

namespace scarab::log {

/// How two logs compare, topic by topic.
struct LogComparison {
  std::string a;  ///< what the logs are called
  std::string b;
  std::vector<TopicComparison> topics;

  bool is_equal() const;
  /// Samples looked at, those that only one log has included.
  std::uint64_t samples() const;
};

/// A line a topic, with the first difference, and a summary.
void print_text(const LogComparison& comparison, std::ostream& out);

/// The same as a JSON object.
void print_json(const LogComparison& comparison, std::ostream& out);

}  // namespace scarab::log
