#include "services/plant/core/simulation.hpp"

#include <cmath>
#include <stdexcept>

#include "services/plant/core/command_delay.hpp"
#include "services/plant/core/morphology.hpp"
#include "services/plant/core/referee.hpp"
#include "services/plant/core/scene.hpp"
#include "services/plant/core/sensor_readings.hpp"
#include "services/plant/core/sensors.hpp"
#include "services/plant/core/stepper.hpp"
#include "services/plant/core/supply_current.hpp"
#include "services/plant/core/timing.hpp"

namespace scarab::plant {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

std::array<double, 3> to_array(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Pose pose(const Vector3d& position, const Eigen::Quaterniond& turn) {
  return {to_array(position), {turn.w(), turn.x(), turn.y(), turn.z()}};
}

Twist twist(const SpeedVector& speed, std::size_t at) {
  return {to_array(speed.segment<3>(static_cast<Index>(at + 3))),
          to_array(speed.segment<3>(static_cast<Index>(at)))};
}

ContactTruth contact_truth(const ResolvedContact& resolved) {
  const Contact& contact = resolved.contact;
  return {contact.a.solid,
          contact.a.leg,
          contact.b.solid,
          contact.b.leg,
          to_array(contact.touch.point),
          to_array(resolved.force_n),
          contact.touch.depth};
}

JointPresence presence(const Morphology& morphology) {
  JointPresence out{};
  for (std::size_t j = 0; j < out.size(); ++j) out[j] = morphology.joints[j].present;
  return out;
}

}  // namespace

class Simulation::Impl {
 public:
  Impl(const robot::RobotModel& robot, const PlantConfig& config, const TrialSpec& trial,
       const robot::JointVector& start_rad)
      : config_(scene_config(config, trial)),
        trial_(trial),
        timing_(make_timing(config.timing)),
        step_s_(static_cast<double>(timing_.step_ns) * 1e-9),
        morphology_(make_morphology(robot, config_.object)),
        wall_(make_wall(config_, trial)),
        referee_(config.referee, trial, wall_),
        stepper_(morphology_, config_, wall_),
        state_(start_state(morphology_, config_, perturbation(trial), start_rad)),
        reference_(state_.joint_rad),
        sensors_(config.sensors, presence(morphology_), trial.seed, timing_.step_ns),
        encoder_offset_rad_(sensors_.encoder_offset_rad()),
        commands_(config.commands, trial.seed, timing_.step_ns, start_rad) {
    settle(start_rad);
    sensors_.see(measured());
    sensors_.sample(0);
    start_ = {state_.object_position.x(), state_.trunk_position};
  }

  [[nodiscard]] Observation observe() const { return sensors_.newest(); }

  [[nodiscard]] WorldTruth truth() const {
    WorldTruth out;
    out.trunk = pose(state_.trunk_position, state_.trunk_orientation);
    out.trunk_twist = twist(state_.speed, kTrunkSpeed);
    out.object = pose(state_.object_position, state_.object_orientation);
    out.object_twist = twist(state_.speed, kObjectSpeed);
    out.object_travel_m = start_.object_x - state_.object_position.x();
    out.obstacle_present = wall_.height > 0;
    out.obstacle_x_m = wall_.x;
    out.obstacle_height_m = wall_.height;
    for (const ResolvedContact& contact : stepper_.contacts()) {
      out.contacts.push_back(contact_truth(contact));
    }
    out.verdict = ruling_.verdict;
    out.verdict_time_s = ruling_.time_s;
    out.verdict_reason = ruling_.reason;
    return out;
  }

  [[nodiscard]] std::int64_t time_ns() const { return time_ns_; }

  void power(const std::bitset<robot::kJointCount>& powered) { stepper_.power(powered); }

  void advance(const robot::JointVector& targets, const std::function<void()>& sample) {
    commands_.send(tick_++, step_, targets);
    for (std::int64_t i = 0; i < timing_.samples_per_tick; ++i) {
      advance_to_next_sample();
      if (sample && i + 1 < timing_.samples_per_tick) sample();
    }
    if (ruling_.verdict == Verdict::kOpen) {
      ruling_ = referee_.judge(standing(state_, static_cast<double>(time_ns_) * 1e-9,
                                        -morphology_.rear_box.low.x(), start_));
    }
  }

 private:
  [[nodiscard]] Observation measured() const {
    Observation out = measure(morphology_, state_, stepper_, config_.gravity_m_s2);
    out.supply_current_a = supply_current_a(config_.supply, out.torque_nm);
    return out;
  }

  /// The stance is reached on the ground before the trial's time begins.
  void settle(const robot::JointVector& targets) {
    const auto steps = std::max<std::int64_t>(
        1, std::llround(config_.start.settle_s * 1e9 / static_cast<double>(timing_.step_ns)));
    for (std::int64_t i = 0; i < steps; ++i) step(targets);
  }

  void advance_to_next_sample() {
    for (std::int64_t k = 0; k < timing_.steps_per_sample; ++k) {
      step(commands_.arrived_at(step_));
      ++step_;
      if (sensors_.needs_every_step() || k + 1 == timing_.steps_per_sample) {
        sensors_.see(measured());
      }
    }
    time_ns_ += timing_.sensor_period_ns;
    sensors_.sample(++sample_);
  }

  /// The servos turn the joints until their encoders read `targets`.
  void step(robot::JointVector targets) {
    for (std::size_t j = 0; j < targets.size(); ++j) targets[j] -= encoder_offset_rad_[j];
    stepper_.step(targets, step_s_, reference_, state_);
    if (!state_.speed.allFinite()) {
      throw std::runtime_error("the plant's motion is no longer finite after " +
                               std::to_string(time_ns_) + " ns");
    }
  }

  PlantConfig config_;
  TrialSpec trial_;
  Timing timing_;
  double step_s_;
  Morphology morphology_;
  Wall wall_;
  Referee referee_;
  Stepper stepper_;
  MotionState state_;
  robot::JointVector reference_;
  SensorReadings sensors_;
  robot::JointVector encoder_offset_rad_;
  CommandDelay commands_;
  StartPlaces start_;
  std::int64_t time_ns_ = 0;
  std::int64_t step_ = 0;     // of the trial; like time_ns_ from the end of the settling
  std::uint64_t sample_ = 0;  // index of the newest
  std::uint64_t tick_ = 0;    // of the next command
  Ruling ruling_;
};

Simulation::Simulation(const robot::RobotModel& robot, const PlantConfig& config,
                       const TrialSpec& trial)
    : Simulation(robot, config, trial, start_targets(config.start)) {}
Simulation::Simulation(const robot::RobotModel& robot, const PlantConfig& config,
                       const TrialSpec& trial, const robot::JointVector& start_rad)
    : impl_(std::make_unique<Impl>(robot, config, trial, start_rad)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Observation Simulation::observe() const { return impl_->observe(); }
WorldTruth Simulation::truth() const { return impl_->truth(); }
std::int64_t Simulation::time_ns() const { return impl_->time_ns(); }

void Simulation::power(const std::bitset<robot::kJointCount>& powered) { impl_->power(powered); }

void Simulation::advance(const robot::JointVector& targets, const std::function<void()>& sample) {
  impl_->advance(targets, sample);
}

}  // namespace scarab::plant
