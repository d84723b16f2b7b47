#include "services/robot_bridge/calibrate/words.hpp"

#include <fmt/format.h>

#include <array>

#include "common/robot/joints.hpp"

namespace scarab::bridge::calibrate {
namespace {

constexpr double kDegreesPerRad = 57.29577951308232;

struct Look {
  const char* at_zero;
  const char* grows;
};

/// Signs: common/robot/joints.hpp. T, C, F, backbone.
constexpr std::array<Look, 4> kLooks = {{
    {"leg straight out sideways", "forwards"},
    {"femur level with the trunk", "upwards"},
    {"knee stretched: tibia in line with the femur", "so that the knee bends, foot down"},
    {"trunk straight", "so that the rear of the trunk goes up"},
}};

const Look& look_of(std::size_t joint) {
  return joint == robot::kBackboneSlot ? kLooks[3] : kLooks[joint / robot::kLegCount];
}

}  // namespace

std::string angle_words(double rad) {
  return fmt::format("{:+.3f} rad ({:+.1f} deg)", rad, rad * kDegreesPerRad);
}

std::string pose_words(std::size_t joint, double joint_rad) {
  if (joint_rad == 0) return look_of(joint).at_zero;
  return fmt::format("{} from \"{}\"", angle_words(joint_rad), look_of(joint).at_zero);
}

std::string positive_words(std::size_t joint) { return look_of(joint).grows; }

}  // namespace scarab::bridge::calibrate
