#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scarab::plant {

/// Solids that can touch. Values equal those of the IDL enumeration Solid.
enum class Solid { kGround, kObject, kObstacle, kTrunk, kCoxa, kFemur, kTibia, kFoot };

/// Values equal those of the IDL enumeration of the same name.
enum class Verdict { kOpen, kSuccess, kFailure };

struct Pose {
  std::array<double, 3> position_m{};
  std::array<double, 4> orientation_wxyz{1, 0, 0, 0};  ///< R_world_body
};

struct Twist {
  std::array<double, 3> linear_m_s{};
  std::array<double, 3> angular_rad_s{};  ///< both in the world frame
};

struct ContactTruth {
  Solid solid_a = Solid::kGround;
  std::uint16_t leg_a = 0;  ///< leg slot; 0 where solid_a is no part of a leg
  Solid solid_b = Solid::kGround;
  std::uint16_t leg_b = 0;
  std::array<double, 3> point_m{};
  std::array<double, 3> force_n{};  ///< on solid_b, in the world
  double depth_m = 0;
};

/// Ground truth that no robot could measure (adapter: scarab/world_state).
struct WorldTruth {
  Pose trunk;  ///< rear trunk segment; its origin is the centre of the undivided trunk
  Twist trunk_twist;
  Pose object;  ///< the cylinder; its axis is the body's y axis
  Twist object_twist;
  double object_travel_m = 0;  ///< of the axis along the path (-x) since the start of the trial
  bool obstacle_present = false;
  double obstacle_x_m = 0;
  double obstacle_height_m = 0;
  std::vector<ContactTruth> contacts;  ///< all; the adapter keeps as many as the topic holds
  Verdict verdict = Verdict::kOpen;    ///< latched
  double verdict_time_s = 0;           ///< since the start of the trial; 0 while open
  std::string verdict_reason;
};

}  // namespace scarab::plant
