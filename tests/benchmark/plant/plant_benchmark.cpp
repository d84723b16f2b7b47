// Speed of the plant alone, in simulated seconds per second of one core's time (CPU time, so that
// other processes on the machine do not count). Standing: the robot in its stance. Pushing: the
// whole task with soft and hard pushing at a 10 cm obstacle, all contacts, from the start to the
// verdict; controller and supervisor are not timed.
#include <benchmark/benchmark.h>

#include <ctime>

#include "common/config/robot_file.hpp"
#include "services/plant/config.hpp"
#include "services/plant/core/scene.hpp"
#include "services/plant/core/simulation.hpp"
#include "services/premotor/config.hpp"
#include "services/premotor/core/premotor_controller.hpp"
#include "services/supervisor/config.hpp"
#include "services/supervisor/core/behaviour_machine.hpp"

namespace {

using namespace scarab;

constexpr const char* kConfig = SCARAB_SOURCE_DIR "/config/";

std::string file(const char* name) { return std::string(kConfig) + name; }

plant::PlantConfig plant_config(double step_s) {
  plant::PlantConfig config = plant::load_config(file("plant/default.yaml"));
  config.timing.step_s = step_s;
  return config;
}

/// Reports ticks as simulated time: `real_time_factor`, and the time of one step.
void report(benchmark::State& state, const plant::PlantConfig& config) {
  const double simulated = static_cast<double>(state.iterations()) * config.timing.control_period_s;
  state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
  state.counters["step"] = benchmark::Counter(
      simulated / config.timing.step_s, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// CPU time of this thread, s.
double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double step_of(const benchmark::State& state) { return 1e-6 * static_cast<double>(state.range(0)); }

void standing(benchmark::State& state) {
  const plant::PlantConfig config = plant_config(step_of(state));
  plant::Simulation simulation(config::load_robot(file("robot/beetle.yaml")), config, {});
  const robot::JointVector targets = plant::start_targets(config.start);
  for (auto _ : state) simulation.advance(targets, nullptr);
  report(state, config);
}

/// The closed loop of plant, supervisor and premotor controller in one process.
class Task {
 public:
  explicit Task(double step_s)
      : config_(plant_config(step_s)),
        robot_(config::load_robot(file("robot/beetle.yaml"))),
        behaviour_config_(supervisor::load_config(file("supervisor/f2.yaml"))),
        machine_(behaviour_config_, supervisor::find_strategy(behaviour_config_, "soft+hard")),
        controller_(premotor::load_config(file("premotor/f2.yaml")), robot_) {}

  /// Advances the plant by one tick and returns the seconds it took; a trial that ends starts anew.
  double tick() {
    if (!simulation_ || simulation_->truth().verdict != plant::Verdict::kOpen) restart();
    const robot::JointVector targets = control();
    const double start = cpu_time();
    simulation_->advance(targets, nullptr);
    return cpu_time() - start;
  }

  [[nodiscard]] const plant::PlantConfig& config() const { return config_; }

 private:
  void restart() {
    plant::TrialSpec trial;
    trial.goal = plant::Goal::kAcross;
    trial.obstacle_height_m = 0.10;
    simulation_ = std::make_unique<plant::Simulation>(robot_, config_, trial);
    behaviour_ = machine_.initial_state();
    network_ = controller_.initial_state(1, false);
    tick_ = 0;
  }

  robot::JointVector control() {
    const plant::Observation seen = simulation_->observe();
    supervisor::Perception perception;
    perception.tick = tick_++;
    perception.pitch_rad = seen.pitch_rad;
    for (const robot::Leg leg : {robot::Leg::kL0, robot::Leg::kR0}) {
      perception.front_f_rad[robot::is_left(leg) ? 0 : 1] =
          seen.position_rad[joint_slot(leg, robot::LegJoint::kFemurTibia)];
    }
    const supervisor::Decision decision = machine_.step(behaviour_, perception);
    premotor::MotorIntent intent;
    intent.inputs = decision.inputs;
    intent.backbone_rad = decision.backbone_rad;
    network_ = controller_.step(network_, intent);
    return controller_.targets(network_, intent);
  }

  plant::PlantConfig config_;
  robot::RobotModel robot_;
  supervisor::SupervisorConfig behaviour_config_;
  supervisor::BehaviourMachine machine_;
  premotor::PremotorController controller_;
  std::unique_ptr<plant::Simulation> simulation_;
  supervisor::MachineState behaviour_;
  premotor::NetworkState network_;
  std::uint32_t tick_ = 0;
};

void pushing(benchmark::State& state) {
  Task task(step_of(state));
  for (auto _ : state) state.SetIterationTime(task.tick());
  report(state, task.config());
}

BENCHMARK(standing)->Arg(2000)->Arg(4000)->ArgName("step_us");
BENCHMARK(pushing)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(4000)
    ->ArgName("step_us")
    ->UseManualTime()
    ->Iterations(600);

}  // namespace

BENCHMARK_MAIN();
