#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "services/premotor/core/network_state.hpp"

namespace scarab::fastdds {

/// The network after a tick of a trial.
struct KeptState {
  std::uint32_t trial = 0;
  std::int64_t tick = -1;
  premotor::NetworkState network;
};

/// Written before the answer goes out, so that a process killed at any moment goes on where it was.
class StateFile {
 public:
  /// `run_dir` empty: nothing is kept.
  StateFile(const std::filesystem::path& run_dir, std::uint32_t instance);

  /// Nothing if there is none, or none that was written whole.
  [[nodiscard]] std::optional<KeptState> read() const;
  /// Whole or not at all. Throws std::runtime_error naming the file.
  void write(const KeptState& state) const;

 private:
  std::filesystem::path path_;
};

}  // namespace scarab::fastdds
