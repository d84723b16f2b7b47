#pragma once

#include <memory>
#include <vector>

#include "common/bus/writer.hpp"
#include "common/robot/robot_model.hpp"
#include "common/runtime/tick_body.hpp"
#include "services/plant/core/simulation.hpp"

namespace scarab::plant {

/// The simulated robot and its world as the tick master moves it.
class PlantBody : public runtime::TickBody {
 public:
  PlantBody(bus::Participant& participant, robot::RobotModel robot, PlantConfig config);

  void begin(const scarab_Trial& trial) override;
  [[nodiscard]] std::int64_t time_ns() const override;
  void observe(scarab_RobotState& state) override;
  [[nodiscard]] robot::JointVector held_rad() const override { return held_rad_; }
  [[nodiscard]] robot::JointVector home_rad() const override;
  void advance(const robot::JointVector& target_rad, const std::function<void()>& sample) override;
  [[nodiscard]] std::optional<runtime::TrialEnd> verdict() const override;
  void end(const runtime::TrialEnd& end) override;
  void publish_own(const scarab_Header& header) override;
  void flush_own() override;

  void add_needs(runtime::PeerCheck& peers) const override;

 private:
  /// A sample that waits for flush_own(), with what it points to.
  struct KeptWorld {
    scarab_WorldState sample{};
    std::vector<scarab_Contact> contacts;
  };

  robot::RobotModel robot_;
  PlantConfig config_;
  bus::Writer<scarab_WorldState> worlds_;
  std::unique_ptr<Simulation> simulation_;
  robot::JointVector held_rad_{};           // the last targets
  std::optional<runtime::TrialEnd> ended_;  // from outside, in place of the referee's verdict
  std::vector<KeptWorld> kept_;
};

}  // namespace scarab::plant
