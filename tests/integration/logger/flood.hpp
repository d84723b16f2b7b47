#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/bus/raw_writer.hpp"
#include "tests/integration/logger/reading.hpp"

namespace scarab::logger::test {

/// Readings on several topics of different rate and QoS, until it is destroyed.
class Flood {
 public:
  explicit Flood(bus::Participant& participant) {
    const auto add = [&](const char* topic, std::uint32_t period_ticks, bool transient_local) {
      bus::RawQos qos;
      if (transient_local) qos.durability = DDS_DURABILITY_TRANSIENT_LOCAL;
      // A recorder that does not run for a second misses nothing; what nobody acknowledges any more
      // because he was killed stays below the 500 kB at which Cyclone would hold the writer.
      qos.history_depth = 1000;
      sources_.push_back(
          {topic, period_ticks, 0,
           std::make_unique<bus::RawWriter>(
               participant, topic, bus::borrow_compiled(bus::descriptor<meadow_Reading>()), qos)});
    };
    add("flood/fast", 1, false);
    add("flood/kept", 10, true);
    add("flood/slow", 50, false);
  }

  static constexpr std::size_t kTopics = 3;

  /// Once a millisecond.
  void tick() {
    for (Source& source : sources_) {
      if (tick_ % source.period_ticks == 0) source.writer->write(encode_reading(source.number++));
    }
    ++tick_;
  }

 private:
  struct Source {
    std::string topic;
    std::uint32_t period_ticks;
    std::uint32_t number;
    std::unique_ptr<bus::RawWriter> writer;
  };
  std::vector<Source> sources_;
  std::uint32_t tick_ = 0;
};

}  // namespace scarab::logger::test
