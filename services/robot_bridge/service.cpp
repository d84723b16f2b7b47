#include "services/robot_bridge/service.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "common/runtime/tick_master.hpp"
#include "services/robot_bridge/bridge_body.hpp"
#include "services/robot_bridge/crash_stop.hpp"

namespace scarab::bridge {

void serve(const runtime::ServiceOptions& options, const BridgeConfig& config,
           const robot::RobotModel& robot, std::unique_ptr<Driver> driver) {
  install_crash_handler();
  const bus::Peer self{"robot_bridge", options.instance};
  bus::ParticipantOptions joins = options.bus.participant(self.service, self.instance);
  joins.gathers_samples = true;
  bus::Participant participant(joins);
  BridgeBody body(participant, with_crash_stop(std::move(driver)), config);

  safety::GateOptions gate_options;
  gate_options.tick_period_s = config.timing.control_period_s;
  gate_options.homing_velocity_rad_s = config.homing_velocity_rad_s;
  gate_options.stale_ticks_limit = 3;  // as the plant in real time
  safety::CommandGate gate(robot, gate_options);

  runtime::TickMasterOptions master_options;
  master_options.pace = runtime::Pace::kRealTime;
  master_options.tick_period =
      std::chrono::nanoseconds(std::llround(config.timing.control_period_s * 1e9));
  master_options.samples_per_tick = samples_per_tick(config.timing);
  master_options.tells_end = true;  // there may be nobody who publishes a world_state
  runtime::TickMaster master(participant, options, self, master_options, body, gate);
  master.run();
}

}  // namespace scarab::bridge
