#include "services/robot_bridge/core/start_pose.hpp"

namespace scarab::bridge {

robot::JointVector joint_targets(const StartPose& pose) {
  const std::array<const std::array<double, 3>*, 3> rows = {&pose.front_rad, &pose.middle_rad,
                                                            &pose.hind_rad};
  robot::JointVector targets_rad{};
  for (const robot::Leg leg : robot::kLegs) {
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const auto slot = robot::joint_slot(leg, static_cast<robot::LegJoint>(joint));
      targets_rad[slot] = (*rows[robot::row(leg)])[joint];
    }
  }
  targets_rad[robot::kBackboneSlot] = pose.backbone_rad;
  return targets_rad;
}

}  // namespace scarab::bridge
