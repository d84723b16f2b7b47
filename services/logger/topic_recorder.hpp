#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/raw_reader.hpp"
#include "common/bus/waitset.hpp"
#include "services/logger/core/chain_writers.hpp"
#include "services/logger/sample_batch.hpp"

namespace scarab::logger {

/// The bus side of the recorder: a type-less reader for every topic that is discovered to have a
/// writer.
class TopicRecorder {
 public:
  /// `wait_set` wakes for everything take() would find; it must outlive this.
  TopicRecorder(bus::Participant& participant, bus::WaitSet& wait_set);

  /// Looks for new topics and takes every sample that waits, as one batch.
  SampleBatch take();

  /// Writers of the chain that no reader here is matched with yet, as `plant/0 to write
  /// scarab/robot_state`.
  std::vector<std::string> missing(const std::vector<ChainWriter>& needed) const;
  /// What keeps topics, or some of their samples, out of the log; empty when all is well.
  std::vector<std::string> faults() const;

 private:
  struct Topic {
    std::unique_ptr<bus::RawReader> reader;
    std::uint32_t channel = 0;
    std::uint32_t next_sequence = 0;
  };
  /// A topic whose type could not be found out yet.
  struct Unknown {
    std::string reason;
    std::chrono::steady_clock::time_point try_again;
  };

  void discover(SampleBatch& batch);
  void add_topic(const bus::DiscoveredEndpoint& writer, SampleBatch& batch);
  void take_from(Topic& topic, SampleBatch& batch);

  bus::Participant& participant_;
  bus::WaitSet& wait_set_;
  bus::Discovery discovery_;
  std::map<std::string, Topic> topics_;
  std::map<std::string, Unknown> unknown_;
};

}  // namespace scarab::logger
