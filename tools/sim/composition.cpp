#include "tools/sim/composition.hpp"

#include <algorithm>
#include <iterator>

#include "common/safety/command_gate.hpp"
#include "services/plant/adapter.hpp"
#include "services/plant/core/scene.hpp"
#include "services/plant/core/simulation.hpp"
#include "services/premotor/adapter.hpp"
#include "services/supervisor/adapter.hpp"
#include "services/supervisor/core/machine_state.hpp"

namespace scarab::sim {
namespace {

class Trial {
 public:
  Trial(const Configuration& configuration, const scarab_Trial& trial, SampleLog& log,
        const Listener& listener)
      : configuration_(configuration),
        trial_(trial),
        log_(log),
        listener_(listener),
        simulation_(configuration.robot, configuration.plant, plant::to_trial_spec(trial)),
        gate_(configuration.robot, configuration.plant.timing.control_period_s),
        machine_(configuration.supervisor,
                 supervisor::find_strategy(configuration.supervisor, trial.strategy)),
        machine_state_(machine_.initial_state()),
        controller_(configuration.premotor, configuration.robot),
        network_state_(controller_.initial_state(trial.seed, trial.perturb_cpg_phase)) {
    const robot::JointVector start_rad = plant::start_targets(configuration.plant.start);
    gate_.begin_trial(trial.header.trial, start_rad, start_rad);
  }

  void run() {
    log_.write(bus::kTrial, trial_);
    while (tick() && !(listener_.interrupted && listener_.interrupted())) ++tick_;
  }

 private:
  /// One tick of the chain; false after the trial's last.
  bool tick() {
    gate_.expect(tick_);
    const scarab_RobotState state = publish_state(bus::kRobotState);
    const scarab_Behaviour behaviour = answer_state(state);
    gate_.offer(answer_behaviour(behaviour));
    if (state.phase != scarab_PHASE_RUNNING) return false;
    simulation_.advance(gate_.target_rad(), [this] { publish_state(bus::kRobotSensors); });
    return true;
  }

  [[nodiscard]] scarab_Header header() const {
    return {trial_.header.trial, tick_, simulation_.time_ns(), bus::now_ns()};
  }

  scarab_RobotState publish_state(const bus::Topic<scarab_RobotState>& topic) {
    const plant::WorldTruth truth = simulation_.truth();
    scarab_RobotState state{};
    state.header = header();
    state.phase = truth.verdict == plant::Verdict::kOpen      ? scarab_PHASE_RUNNING
                  : truth.verdict == plant::Verdict::kSuccess ? scarab_PHASE_SUCCEEDED
                                                              : scarab_PHASE_FAILED;
    plant::fill(state, simulation_.observe(), configuration_.robot);
    log_.write(topic, state);
    scarab_WorldState world{};
    world.header = state.header;
    plant::fill(world, truth, contacts_);
    log_.write(bus::kWorldState, world);
    if (listener_.world) listener_.world(world);
    return state;
  }

  scarab_Behaviour answer_state(const scarab_RobotState& state) {
    scarab_Behaviour behaviour{};
    behaviour.header = header();
    supervisor::fill(behaviour, machine_.step(machine_state_, supervisor::to_perception(state)));
    log_.write(bus::kBehaviour, behaviour);
    if (listener_.behaviour) listener_.behaviour(behaviour);
    return behaviour;
  }

  safety::Offer answer_behaviour(const scarab_Behaviour& behaviour) {
    const auto intent = premotor::to_intent(behaviour);
    network_state_ = controller_.step(network_state_, intent);
    scarab_NeuralActivity activity{};
    activity.header = header();
    premotor::fill(activity, network_state_);
    log_.write(bus::kNeuralActivity, activity);
    scarab_JointCommand command{};
    command.header = header();
    premotor::fill(command, controller_.targets(network_state_, intent), intent.stop);
    log_.write(bus::kJointCommand, command);
    safety::Offer offer{command.header.trial, command.header.tick, intent.stop, {}};
    std::copy(std::begin(command.position_rad), std::end(command.position_rad),
              offer.position_rad.begin());
    return offer;
  }

  const Configuration& configuration_;
  scarab_Trial trial_;
  SampleLog& log_;
  const Listener& listener_;
  plant::Simulation simulation_;
  safety::CommandGate gate_;
  supervisor::BehaviourMachine machine_;
  supervisor::MachineState machine_state_;
  premotor::PremotorController controller_;
  premotor::NetworkState network_state_;
  std::vector<scarab_Contact> contacts_;
  std::uint32_t tick_ = 0;
};

}  // namespace

void run_trial(const Configuration& configuration, const scarab_Trial& trial, SampleLog& log,
               const Listener& listener) {
  Trial(configuration, trial, log, listener).run();
}

}  // namespace scarab::sim
