#pragma once

#include <array>
#include <map>
#include <string>

#include "services/supervisor/core/strategy.hpp"

/// Parameters of the behaviour machine: pure data, filled from config/supervisor/*.yaml.
namespace scarab::supervisor {

/// Inputs I1..I4 of each mode (paper, Table 1). Stop keeps the network running.
struct ModeInputs {
  std::array<double, 4> stop{};
  std::array<double, 4> forward{};
  std::array<double, 4> backward{};
  std::array<double, 4> soft_push{};
  std::array<double, 4> boxing{};
  std::array<double, 4> stationary{};
  std::array<double, 4> hard_push{};
};

/// BS, the inclination signal: exponential mean of the rear pitch.
struct InclinationConfig {
  double smoothing = 0;       ///< share of the newest sample in the mean, (0, 1]
  double threshold_rad = 0;   ///< above: the robot is on the object
  unsigned settle_ticks = 0;  ///< consecutive ticks above the threshold before mode 1, >= 1
};

/// AS, the front legs' F-joint angle, averaged over one period of the CPG.
struct FrontAngleConfig {
  /// The CPG's period, need not be whole; 1..kMaxWindowTicks. Of the other triggers' signals, too.
  double window_ticks = 0;
  double reference_rad = 0;    ///< F0, the angle that the front F-joints are told to hold
  double drop_rad = 0;         ///< below reference_rad - drop_rad: the object is blocked
  unsigned confirm_ticks = 0;  ///< consecutive ticks below before mode 2, >= 1
  unsigned arm_ticks = 0;      ///< not before so many ticks of mode 1
};

/// The robot's supply current, averaged as AS is: it rises when the legs push against a blocked
/// object.
struct SupplyCurrentConfig {
  double reference_a = 0;      ///< while the object rolls freely in mode 1
  double rise_a = 0;           ///< above reference_a + rise_a: the object is blocked
  unsigned confirm_ticks = 0;  ///< consecutive ticks above before mode 2, >= 1
  unsigned arm_ticks = 0;      ///< not before so many ticks of mode 1
};

/// The normal force on the front feet, the mean of the two, averaged as AS is.
struct FootForceConfig {
  double reference_n = 0;      ///< while the object rolls freely in mode 1
  double rise_n = 0;           ///< above reference_n + rise_n: the object is blocked
  unsigned confirm_ticks = 0;  ///< consecutive ticks above before mode 2, >= 1
  unsigned arm_ticks = 0;      ///< not before so many ticks of mode 1
};

struct SupervisorConfig {
  InclinationConfig bs;
  FrontAngleConfig as;
  SupplyCurrentConfig supply_current;
  FootForceConfig foot_force;
  double backbone_rad = 0;  ///< held in every mode, + = rear up
  std::array<double, 3>
      stationary_hind_pose_rad{};  ///< T, C, F of both hind legs in stationary mode
  ModeInputs inputs;
  std::map<std::string, Strategy> strategies;
};

/// Why there is no strategy of that name, with the list of those there are; empty: there is one.
std::string refusal_of_strategy(const SupervisorConfig& config, const std::string& name);

/// The strategy of that name; throws std::invalid_argument with the list of names if there is none.
const Strategy& find_strategy(const SupervisorConfig& config, const std::string& name);

/// Inputs I1..I4 of a mode.
std::array<double, 4> inputs_of(const SupervisorConfig& config, Mode mode);

}  // namespace scarab::supervisor
