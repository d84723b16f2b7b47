#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "common/robot/robot_model.hpp"
#include "services/plant/core/plant_config.hpp"
#include "services/plant/core/simulation.hpp"
#include "tools/emulator/boards/board.hpp"

namespace scarab::emulator {

/// When the world has had to leave out time, because its computer did not come round to it.
struct Lateness {
  std::uint64_t count = 0;
  std::int64_t lost_ns = 0;  ///< all together
};

/// The robot's body and what is around it, moving by a clock that is given: the plant's physics in
/// steps of at most kStepNs. It stands still, as if somebody held the robot, until start().
class World {
 public:
  static constexpr std::int64_t kStepNs = 2'000'000;
  /// Further behind than this it does not catch up: that time is lost.
  static constexpr std::int64_t kBehindMostNs = 100'000'000;

  /// A world without an obstacle, standing still. `sensor_period_s` is how often `sample` is called
  /// in advance(). Throws std::invalid_argument naming what of the configuration does not fit.
  World(robot::RobotModel robot, plant::PlantConfig config, double sensor_period_s);

  /// Builds it anew for a trial, with the joints at `start_rad`, standing still. Throws
  /// std::invalid_argument; then it stays as it was.
  void build(const plant::TrialSpec& trial, const robot::JointVector& start_rad);
  /// The same in two steps. Building takes milliseconds, replacing none: whoever cannot wait that
  /// long has another thread prepare it, while this one goes on.
  [[nodiscard]] std::unique_ptr<plant::Simulation> prepare(
      const plant::TrialSpec& trial, const robot::JointVector& start_rad) const;
  /// Returns the old one.
  std::unique_ptr<plant::Simulation> replace(std::unique_ptr<plant::Simulation> prepared);
  /// From now on it moves: this is its t = 0.
  void start(std::int64_t now_ns);
  [[nodiscard]] bool runs() const { return runs_; }

  /// Moves on to `now_ns`: servos with power towards their targets, but for those that are stuck.
  /// Calls `sample` after each sensor period. Throws std::runtime_error if the motion is no longer
  /// finite; then it stands still.
  void advance(std::int64_t now_ns, const Drive& drive,
               const std::bitset<robot::kJointCount>& stuck, const std::function<void()>& sample);
  /// When its next step is due; only while it runs.
  [[nodiscard]] std::int64_t next_step_ns() const { return origin_ns_ + time_ns() + step_ns_; }

  [[nodiscard]] std::int64_t time_ns() const { return simulation_->time_ns(); }
  [[nodiscard]] plant::Observation observe() const { return simulation_->observe(); }
  [[nodiscard]] plant::WorldTruth truth() const { return simulation_->truth(); }
  [[nodiscard]] const Lateness& lateness() const { return lateness_; }
  /// Where the joints are by the configuration when a trial begins.
  [[nodiscard]] robot::JointVector configured_start_rad() const;

 private:
  void leave_out_what_is_lost(std::int64_t now_ns);
  void step(const Drive& drive, const std::bitset<robot::kJointCount>& stuck);

  robot::RobotModel robot_;
  plant::PlantConfig config_;
  std::int64_t step_ns_;
  std::int64_t sensor_period_ns_;
  std::unique_ptr<plant::Simulation> simulation_;
  bool runs_ = false;
  std::int64_t origin_ns_ = 0;  // of t = 0, by the given clock
  Lateness lateness_;
  std::array<std::optional<double>, robot::kJointCount> stuck_at_rad_;
};

}  // namespace scarab::emulator
