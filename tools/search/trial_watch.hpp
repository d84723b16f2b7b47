#pragma once

#include <array>
#include <optional>

#include "common/bus/topics.hpp"
#include "services/plant/core/plant_config.hpp"
#include "tools/search/description.hpp"
#include "tools/search/measure.hpp"

namespace scarab::search {

/// Follows one trial and measures what the objective needs.
class TrialWatch {
 public:
  /// A trial in which nothing has moved for `give_up_s` is stuck; infinity: none ever is.
  TrialWatch(const Scenario& scenario, const plant::PlantConfig& plant, double give_up_s);

  void see(const scarab_WorldState& world);
  void see(const scarab_Behaviour& behaviour);

  /// Nothing more is to be expected of it.
  [[nodiscard]] bool stuck() const;
  [[nodiscard]] Measure measure() const;

 private:
  /// What the first sample showed.
  struct Start {
    double trunk_x = 0, trunk_y = 0, yaw_rad = 0, object_x = 0, object_z = 0;
  };

  [[nodiscard]] double way_share(const scarab_WorldState& world) const;
  void follow_heading(const scarab_WorldState& world);
  void follow_contacts(const scarab_WorldState& world);
  void follow_motion(const scarab_WorldState& world);

  Scenario scenario_;
  double across_margin_m_;
  double object_weight_n_;
  double give_up_s_;
  std::optional<Start> start_;
  Measure measure_;
  double last_yaw_rad_ = 0;        ///< as the quaternion gives it
  double turned_rad_ = 0;          ///< since the start, unwrapped
  double trunk_way_m_ = 0;         ///< farthest from the start
  double travel_m_ = 0;            ///< farthest of the object
  double rise_m_ = 0;              ///< highest of the object's axis
  std::array<double, 3> moved_{};  ///< the three above when something last moved
  double moved_time_s_ = 0;
  unsigned samples_ = 0;
  unsigned leg_leg_samples_ = 0;
  bool touched_ = false;  ///< the robot has been in contact with the object
  double carried_ = 0;    ///< sum over samples, in object weights
};

}  // namespace scarab::search
