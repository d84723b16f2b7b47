#include "services/plant/service.hpp"

#include <cmath>

#include "services/plant/core/morphology.hpp"
#include "services/plant/plant_body.hpp"

namespace scarab::plant {

void serve(const runtime::ServiceOptions& options, runtime::Pace pace, const PlantConfig& config,
           const robot::RobotModel& robot) {
  const bus::Peer self{"plant", options.instance};
  bus::ParticipantOptions joins = options.bus.participant(self.service, self.instance);
  joins.gathers_samples = true;
  bus::Participant participant(joins);
  PlantBody body(participant, robot, config);
  safety::GateOptions gate_options;
  gate_options.tick_period_s = config.timing.control_period_s;
  // In lockstep the tick master waits for every command; in real time three ticks without one bring
  // the safe stop.
  gate_options.stale_ticks_limit = pace == runtime::Pace::kRealTime ? 3 : 0;
  safety::CommandGate gate(robot, gate_options);

  runtime::TickMasterOptions master_options;
  master_options.pace = pace;
  master_options.tick_period =
      std::chrono::nanoseconds(std::llround(config.timing.control_period_s * 1e9));
  master_options.samples_per_tick = static_cast<unsigned>(
      std::lround(config.timing.control_period_s / config.timing.sensor_period_s));
  runtime::TickMaster master(participant, options, self, master_options, body, gate);
  master.run();
}

void require_simulable(const robot::RobotModel& robot, const PlantConfig& config) {
  (void)make_morphology(robot, config.object);
}

}  // namespace scarab::plant
