#include "tools/search/evaluation.hpp"

#include <exception>
#include <limits>
#include <mutex>
#include <thread>

#include "tools/search/trial_watch.hpp"

namespace scarab::search {
namespace {

bool is_set(const std::atomic<bool>* flag) { return flag != nullptr && flag->load(); }

/// All trials of an evaluation and the threads that take them one by one.
class Work {
 public:
  Work(const Description& description, const std::vector<sim::Configuration>& configurations,
       const Plan& plan, const EvaluationOptions& options)
      : description_(description),
        configurations_(configurations),
        plan_(plan),
        options_(options),
        results_(configurations.size(), Measures(plan.size())) {}

  std::vector<Measures> run() {
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < options_.jobs; ++i) threads.emplace_back([this] { take(); });
    take();
    for (std::thread& thread : threads) thread.join();
    if (is_set(options_.interrupted)) return {};
    return std::move(results_);
  }

 private:
  void take() {
    const std::size_t all = configurations_.size() * plan_.size();
    for (std::size_t i = next_++; i < all && !is_set(options_.interrupted); i = next_++) {
      const std::size_t candidate = i / plan_.size();
      const std::size_t trial = i % plan_.size();
      results_[candidate][trial] =
          run_planned(description_, configurations_[candidate], plan_[trial], options_);
      const std::lock_guard<std::mutex> lock(progress_);
      if (options_.progress) options_.progress(++done_, all);
    }
  }

  const Description& description_;
  const std::vector<sim::Configuration>& configurations_;
  const Plan& plan_;
  const EvaluationOptions& options_;
  std::vector<Measures> results_;
  std::atomic<std::size_t> next_{0};
  std::mutex progress_;
  std::size_t done_ = 0;
};

}  // namespace

Measure run_planned(const Description& description, const sim::Configuration& configuration,
                    const PlannedTrial& planned, const EvaluationOptions& options) {
  const double give_up_s =
      options.give_up ? description.give_up_s : std::numeric_limits<double>::infinity();
  TrialWatch watch(description.scenarios[planned.scenario], configuration.plant, give_up_s);
  sim::Listener listener;
  listener.world = [&](const scarab_WorldState& world) { watch.see(world); };
  listener.behaviour = [&](const scarab_Behaviour& behaviour) { watch.see(behaviour); };
  listener.interrupted = [&] { return watch.stuck() || is_set(options.interrupted); };
  sim::SampleLog nothing("");
  try {
    sim::run_trial(configuration, make_trial(description, planned), nothing, listener);
  } catch (const std::exception& error) {
    Measure measure;
    measure.reason = error.what();
    return measure;
  }
  return watch.measure();
}

std::vector<Measures> evaluate(const Description& description,
                               const std::vector<sim::Configuration>& configurations,
                               const Plan& plan, const EvaluationOptions& options) {
  return Work(description, configurations, plan, options).run();
}

}  // namespace scarab::search
