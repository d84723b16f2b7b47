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

  /// A batch without samples: those the bus has said were lost or rejected since the last call.
  SampleBatch losses();

  /// Writers of the chain that no reader here is matched with yet, as `plant/0 to write
  /// scarab/robot_state`. A match counts once it is kHandshake old, for whatever topic.
  std::vector<std::string> missing(const std::vector<ChainWriter>& needed);
  /// What keeps topics out of the log; empty when all is well.
  std::vector<std::string> faults() const;

 private:
  struct Topic {
    std::unique_ptr<bus::RawReader> reader;
    std::uint32_t channel = 0;
    std::uint32_t next_sequence = 0;
    std::uint64_t known_lost = 0;  // of the bus, as of the last losses()
  };
  /// A topic whose type could not be found out yet.
  struct Unknown {
    std::string reason;
    std::chrono::steady_clock::time_point try_again;
  };

  /// Cyclone drops what a volatile writer sends before its reader has seen a heartbeat; the reader
  /// asks for one 10 ms after the match (PreEmptiveAckDelay). Nothing tells when it has come, so a
  /// match is given five times as long.
  static constexpr std::chrono::milliseconds kHandshake{50};

  bool has_settled(const std::string& topic, const bus::Peer& peer);
  void discover(SampleBatch& batch);
  void add_topic(const bus::DiscoveredEndpoint& writer, SampleBatch& batch);
  void take_from(Topic& topic, SampleBatch& batch);

  bus::Participant& participant_;
  bus::WaitSet& wait_set_;
  bus::Discovery discovery_;
  std::map<std::string, Topic> topics_;
  std::map<std::string, Unknown> unknown_;
  std::chrono::steady_clock::time_point newest_reader_{};
  /// Since when a peer has been seen matched on a topic.
  std::map<std::pair<std::string, bus::Peer>, std::chrono::steady_clock::time_point> matched_since_;
};

}  // namespace scarab::logger
