#include "tools/emulator/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "services/plant/core/scene.hpp"

namespace scarab::emulator {
namespace {

constexpr double kNsPerS = 1e9;

std::int64_t to_ns(double seconds) { return std::llround(seconds * kNsPerS); }

/// As many steps of the physics as fit into World::kStepNs, and at least one.
std::int64_t steps_together_ns(const plant::TimingConfig& timing) {
  const std::int64_t physics_ns = to_ns(timing.step_s);
  return std::max<std::int64_t>(1, World::kStepNs / physics_ns) * physics_ns;
}

plant::PlantConfig in_short_steps(plant::PlantConfig config, std::int64_t step_ns) {
  config.timing.sensor_period_s = config.timing.control_period_s =
      static_cast<double>(step_ns) / kNsPerS;
  return config;
}

}  // namespace

World::World(robot::RobotModel robot, plant::PlantConfig config, double sensor_period_s)
    : robot_(std::move(robot)),
      config_(in_short_steps(std::move(config), steps_together_ns(config.timing))),
      step_ns_(to_ns(config_.timing.sensor_period_s)),
      sensor_period_ns_(to_ns(sensor_period_s)) {
  build({}, configured_start_rad());
}

robot::JointVector World::configured_start_rad() const {
  return plant::start_targets(config_.start);
}

void World::build(const plant::TrialSpec& trial, const robot::JointVector& start_rad) {
  (void)replace(prepare(trial, start_rad));
}

std::unique_ptr<plant::Simulation> World::prepare(const plant::TrialSpec& trial,
                                                  const robot::JointVector& start_rad) const {
  return std::make_unique<plant::Simulation>(robot_, config_, trial, start_rad);
}

std::unique_ptr<plant::Simulation> World::replace(std::unique_ptr<plant::Simulation> prepared) {
  runs_ = false;
  stuck_at_rad_ = {};
  return std::exchange(simulation_, std::move(prepared));
}

void World::start(std::int64_t now_ns) {
  origin_ns_ = now_ns;
  runs_ = true;
}

void World::advance(std::int64_t now_ns, const Drive& drive,
                    const std::bitset<robot::kJointCount>& stuck,
                    const std::function<void()>& sample) {
  if (!runs_) return;
  leave_out_what_is_lost(now_ns);
  while (next_step_ns() <= now_ns) {
    step(drive, stuck);
    if (time_ns() / sensor_period_ns_ != (time_ns() - step_ns_) / sensor_period_ns_) sample();
  }
}

void World::leave_out_what_is_lost(std::int64_t now_ns) {
  const std::int64_t behind_ns = now_ns - origin_ns_ - time_ns();
  if (behind_ns <= kBehindMostNs) return;
  ++lateness_.count;
  lateness_.lost_ns += behind_ns;
  origin_ns_ += behind_ns;
}

void World::step(const Drive& drive, const std::bitset<robot::kJointCount>& stuck) {
  robot::JointVector target_rad = drive.target_rad;
  const robot::JointVector position_rad = simulation_->observe().position_rad;
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    if (!stuck[j]) {
      stuck_at_rad_[j].reset();
    } else if (!stuck_at_rad_[j]) {
      stuck_at_rad_[j] = position_rad[j];
    }
    if (stuck_at_rad_[j]) target_rad[j] = *stuck_at_rad_[j];
    if (!drive.powered[j]) target_rad[j] = position_rad[j];
  }
  simulation_->power(drive.powered);
  try {
    simulation_->advance(target_rad, nullptr);
  } catch (const std::runtime_error&) {
    runs_ = false;
    throw;
  }
}

}  // namespace scarab::emulator
