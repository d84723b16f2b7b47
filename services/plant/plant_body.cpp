#include "services/plant/plant_body.hpp"

#include "services/plant/adapter.hpp"
#include "services/plant/core/scene.hpp"

namespace scarab::plant {

PlantBody::PlantBody(bus::Participant& participant, robot::RobotModel robot, PlantConfig config)
    : robot_(std::move(robot)),
      config_(std::move(config)),
      worlds_(participant, bus::kWorldState) {}

void PlantBody::begin(const scarab_Trial& trial) {
  simulation_ = std::make_unique<Simulation>(robot_, config_, to_trial_spec(trial));
  held_rad_ = home_rad();
  ended_.reset();
}

std::int64_t PlantBody::time_ns() const { return simulation_->time_ns(); }

void PlantBody::observe(scarab_RobotState& state) { fill(state, simulation_->observe(), robot_); }

robot::JointVector PlantBody::home_rad() const { return start_targets(config_.start); }

void PlantBody::advance(const robot::JointVector& target_rad, const std::function<void()>& sample) {
  held_rad_ = target_rad;
  simulation_->advance(target_rad, sample);
}

std::optional<runtime::TrialEnd> PlantBody::verdict() const {
  if (ended_) return ended_;
  const WorldTruth truth = simulation_->truth();
  if (truth.verdict == Verdict::kOpen) return std::nullopt;
  return runtime::TrialEnd{truth.verdict == Verdict::kSuccess, truth.verdict_reason};
}

void PlantBody::end(const runtime::TrialEnd& end) { ended_ = end; }

void PlantBody::publish_own(const scarab_Header& header) {
  KeptWorld& world = kept_.emplace_back();
  world.sample.header = header;
  WorldTruth truth = simulation_->truth();
  if (ended_) {
    truth.verdict = ended_->success ? Verdict::kSuccess : Verdict::kFailure;
    truth.verdict_time_s = static_cast<double>(time_ns()) * 1e-9;
    truth.verdict_reason = ended_->reason;
  }
  fill(world.sample, truth, world.contacts);
}

void PlantBody::flush_own() {
  for (const KeptWorld& world : kept_) worlds_.stage(world.sample);
  kept_.clear();
  worlds_.flush();
}

void PlantBody::add_needs(runtime::PeerCheck& peers) const { peers.need(worlds_, "logger"); }

}  // namespace scarab::plant
