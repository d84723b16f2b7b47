#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "tests/support/eventually.hpp"

namespace scarab::test {

/// Everything that came in on a topic of the chain whose type holds no pointers.
template <class T>
class Inbox {
 public:
  Inbox(bus::Participant& participant, const bus::Topic<T>& topic) : reader_(participant, topic) {}

  /// All so far, in order of reception.
  const std::vector<T>& all() {
    reader_.take([this](const T& sample) { samples_.push_back(sample); });
    return samples_;
  }
  /// How often a tick has come so far.
  std::size_t count(std::uint32_t trial, std::uint32_t tick) {
    const auto& samples = all();
    return static_cast<std::size_t>(std::count_if(
        samples.begin(), samples.end(), [&](const T& s) { return is(s.header, trial, tick); }));
  }
  /// The first sample of a tick, waited for; nothing after `limit`.
  std::optional<T> await(std::uint32_t trial, std::uint32_t tick,
                         std::chrono::milliseconds limit = kPatience) {
    std::optional<T> found;
    eventually(
        [&] {
          for (const T& sample : all()) {
            if (!found && is(sample.header, trial, tick)) found = sample;
          }
          return found.has_value();
        },
        limit);
    return found;
  }
  [[nodiscard]] std::vector<bus::Peer> matched() const { return reader_.matched(); }

 private:
  static bool is(const scarab_Header& header, std::uint32_t trial, std::uint32_t tick) {
    return header.trial == trial && header.tick == tick;
  }

  bus::Reader<T> reader_;
  std::vector<T> samples_;
};

}  // namespace scarab::test
