#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/sample/field_path.hpp"
#include "common/sample/sample_filter.hpp"
#include "tools/log/log.hpp"

namespace scarab::log {

/// Which messages of a log are meant, as a person says it.
struct SelectionOptions {
  std::set<std::string> topics;        ///< none: all
  std::optional<std::uint32_t> trial;  ///< only samples of this trial
  std::string filter;                  ///< see bus::SampleFilter; empty: every sample
  std::vector<std::string> fields;     ///< parts of each sample; none: all of it
};

/// The same for the channels of one log. With topics named, all of it has to make sense for each of
/// them; without, topics that have no such field, or no trial, are left out.
class Selection {
 public:
  /// Throws std::invalid_argument saying what is wrong: no such topic (and which there are), a
  /// topic without type or header, a field or filter that no topic has. `log` must outlive this.
  Selection(const Log& log, const SelectionOptions& options);

  /// The topics that can have messages of the selection.
  const std::set<std::string>& topics() const { return topics_; }
  /// Throws bus::Error where the filter needs to read bytes that are no sample.
  bool takes(const LogChannel& channel, const mcap::Message& message) const;
  /// The parts asked for of this channel's samples; empty: all of them.
  const std::vector<sample::FieldPath>& fields(const LogChannel& channel) const;

 private:
  struct Query {
    std::optional<sample::SampleFilter> filter;
    std::vector<sample::FieldPath> fields;
  };

  const Query* query_of(const LogChannel& channel) const;

  std::optional<std::uint32_t> trial_;
  bool has_query_ = false;
  std::set<std::string> topics_;
  mutable std::map<const LogChannel*, std::optional<Query>> queries_;  // made when first met
  SelectionOptions options_;
};

}  // namespace scarab::log
