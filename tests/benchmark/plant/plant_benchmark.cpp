// Speed of the plant alone, in simulated seconds per second of one core's time (CPU time, so that
// other processes on the machine do not count). Standing: the robot in its stance. Pushing: the
// whole task with soft and hard pushing at a 10 cm obstacle, all contacts, from the start to the
// verdict; controller and supervisor are not timed.
#include <benchmark/benchmark.h>

#include <ctime>
#include <memory>
#include <string>

#include "common/config/robot_file.hpp"
#include "services/plant/config.hpp"
#include "services/plant/core/scene.hpp"
#include "tests/unit/plant/closed_loop.hpp"

namespace {

using namespace scarab;

constexpr const char* kConfig = SCARAB_SOURCE_DIR "/config/";

std::string file(const char* name) { return std::string(kConfig) + name; }

plant::PlantConfig plant_config(double step_s) {
  plant::PlantConfig config = plant::load_config(file("plant/beetle.yaml"));
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

void pushing(benchmark::State& state) {
  const plant::PlantConfig config = plant_config(step_of(state));
  plant::TrialSpec trial;
  trial.goal = plant::Goal::kAcross;
  trial.obstacle_height_m = 0.10;
  std::unique_ptr<plant::testing::ClosedLoop> loop;
  for (auto _ : state) {
    if (!loop || loop->plant().truth().verdict != plant::Verdict::kOpen) {
      loop = std::make_unique<plant::testing::ClosedLoop>("soft+hard", config, trial);
    }
    const robot::JointVector targets = loop->decide();
    const double start = cpu_time();
    loop->plant().advance(targets, nullptr);
    state.SetIterationTime(cpu_time() - start);
  }
  report(state, config);
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
