#pragma once

#include <array>
#include <optional>

#include "common/robot/joints.hpp"
#include "common/robot/robot_model.hpp"
#include "services/premotor/core/network_state.hpp"
#include "services/premotor/core/premotor_config.hpp"

namespace scarab::premotor {

/// T, C, F of both hind legs in place of their motor neurons, rad.
using HindPose = std::optional<std::array<double, 3>>;

/// From motor neurons m to joint targets (rad), for each leg with the values of its row [R]:
///
///     T = t_offset + t_gain m_T
///     C = c_offset + c_gain max(c_floor, m_C) + c_i4_gain I4
///     F = f_offset + f_i3_gain I3
///
/// each clipped to the joint's range; the backbone's target is given. I3 and I4 shift offsets
/// (paper, section 2.4) and so act at once, as the outputs of the input neurons in the same state.
/// Absent joints get 0.
class MotorMap {
 public:
  /// Throws std::invalid_argument, naming the value or joint, for a number that is not finite or an
  /// empty joint range.
  MotorMap(const MotorConfig& config, const robot::RobotModel& robot);

  [[nodiscard]] robot::JointVector targets(const NetworkState& state, const HindPose& hind_pose,
                                           double backbone_rad) const;

 private:
  std::array<MotorRowConfig, 3> rows_;  ///< front, middle, hind
  std::array<robot::Joint, robot::kJointCount> joints_;
};

}  // namespace scarab::premotor
