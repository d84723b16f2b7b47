#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "services/logger/sample_batch.hpp"

namespace scarab::logger {

/// What of each topic will not be in the file, since the start.
class LossAccount {
 public:
  void note(const SampleBatch& batch);

  const Loss& total() const { return total_; }
  /// `17 samples dropped (a/topic 12, b/topic 5)`; empty when none was.
  std::string dropped_in_words() const;

 private:
  std::vector<std::string> topics_;  // by channel
  std::map<std::string, Loss> by_topic_;
  Loss total_;
};

}  // namespace scarab::logger
