#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "services/supervisor/core/mode.hpp"

namespace scarab::supervisor {

/// What a hand-driven robot is held to, in place of what the strategy would decide.
struct Manual {
  enum class Hold : std::uint32_t { kNothing, kMode, kInputs };

  Hold hold = Hold::kNothing;
  Mode mode = Mode::kStop;
  std::array<double, 4> inputs{};  ///< I1..I4, each in [-1, 1]; of Hold::kInputs
};

/// Such as "mode soft_push" or "inputs 1 -1 1 0.5".
std::string phrase(const Manual& manual);

}  // namespace scarab::supervisor
