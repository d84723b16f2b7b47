#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/raw_cdr.hpp"

namespace scarab::test {

/// What a trial was: every sample of the chain's topics, without its wall-clock stamp.
class Trajectory {
 public:
  /// Tick and simulated time, ns.
  using Key = std::pair<std::uint32_t, std::int64_t>;
  /// Of one topic, in order.
  using Samples = std::map<Key, sample::Bytes>;

  /// The topics that make it up.
  static const std::vector<std::string>& topics();
  /// What an MCAP file holds of it, closed or not.
  static Trajectory read(const std::filesystem::path& log);

  /// Takes in a sample as a type-less reader takes it. One that comes again, as from a restarted
  /// service, must be the same again.
  void add(const std::string& topic, sample::ByteView cdr);

  /// The same without what says whether it was run in real time.
  [[nodiscard]] Trajectory paceless() const;

  [[nodiscard]] const Samples& of(const std::string& topic) const;
  /// In words, what here is other than in `whole`, or not in it at all; empty if this is a part of
  /// it.
  [[nodiscard]] std::vector<std::string> contradictions(const Trajectory& whole) const;
  /// What of `whole` is missing here.
  struct Gap {
    std::string topic;
    std::uint32_t tick;
  };
  [[nodiscard]] std::vector<Gap> gaps(const Trajectory& whole) const;

 private:
  std::map<std::string, Samples> samples_;
  std::vector<std::string> changed_;  // samples that came again, and other
};

}  // namespace scarab::test
