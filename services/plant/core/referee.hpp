#pragma once

#include <string>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/contact_geometry.hpp"
#include "services/plant/core/plant_config.hpp"
#include "services/plant/core/trial_spec.hpp"
#include "services/plant/core/world_truth.hpp"

namespace scarab::plant {

struct Ruling {
  Verdict verdict = Verdict::kOpen;
  double time_s = 0;   ///< 0 while open
  std::string reason;  ///< one sentence with figures; empty while open
};

/// What the referee looks at.
struct Standing {
  double time_s = 0;
  Eigen::Vector3d trunk_end = Eigen::Vector3d::Zero();  ///< middle of the trunk's rear end
  double trunk_tilt_rad = 0;                            ///< of its vertical against gravity
  Eigen::Vector3d object = Eigen::Vector3d::Zero();     ///< middle of the object's axis
  double object_travel_m = 0;
  double trunk_travel_m = 0;  ///< horizontally, from where it started
};

/// Where things were when the trial's time began.
struct StartPlaces {
  double object_x = 0;
  Eigen::Vector3d trunk = Eigen::Vector3d::Zero();
};

/// Judges a trial's goal on the ground truth.
///
/// travel: the object has travelled the distance. across: the object's axis is across_margin_m past
/// the wall (towards -x). walk: the robot is the distance away from its start. Failure: robot
/// overturned; object lost (too far from the trunk's end, along the path or sideways); time limit,
/// which without a goal is the success instead.
class Referee {
 public:
  Referee(const RefereeConfig& config, const TrialSpec& trial, const Wall& wall);

  [[nodiscard]] Ruling judge(const Standing& now) const;

 private:
  RefereeConfig config_;
  TrialSpec trial_;
  Wall wall_;
};

[[nodiscard]] Standing standing(const MotionState& state, double time_s, double trunk_half_length_m,
                                const StartPlaces& start);

}  // namespace scarab::plant
