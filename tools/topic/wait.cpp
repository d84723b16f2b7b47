#include <CLI/CLI.hpp>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>

#include "common/runtime/program.hpp"
#include "common/sample/sample_filter.hpp"
#include "tools/topic/arrival_rate.hpp"
#include "tools/topic/command_options.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/failure.hpp"
#include "tools/topic/follower.hpp"
#include "tools/topic/quantity.hpp"

namespace scarab::topic {
namespace {

struct WaitOptions {
  std::string topic;
  std::optional<double> hz;
  std::optional<std::uint64_t> count;
  std::optional<double> timeout_s;
  std::string filter;
};

/// What has come of what is waited for.
class Progress {
 public:
  explicit Progress(const WaitOptions& options) : options_(options) {
    if (options.hz) rate_.emplace(*options.hz);
  }

  void add(const bus::RawSample& sample) {
    ++samples_;
    if (rate_) rate_->add(sample.reception_ns);
  }
  bool done() const {
    return samples_ >= options_.count.value_or(1) && (!rate_ || rate_->reached());
  }
  std::string text() const {
    std::string out = counted(samples_, "sample");
    if (!options_.filter.empty()) out += " that match the filter";
    if (rate_) out += ", " + rounded(rate_->rate_hz()) + " Hz of " + rounded(*options_.hz);
    return out;
  }

 private:
  const WaitOptions& options_;
  std::uint64_t samples_ = 0;
  std::optional<ArrivalRate> rate_;
};

int wait(const runtime::BusOptions& bus_options, const WaitOptions& options) {
  Session session(bus_options);
  const auto end =
      options.timeout_s ? after(milliseconds(*options.timeout_s)) : Clock::time_point::max();
  // Arrivals make a rate, not what was kept.
  Follower follower(session, options.topic, end, {!options.hz});
  std::optional<sample::SampleFilter> filter;
  if (!options.filter.empty()) {
    refuse_bad_usage("--filter", [&] { filter.emplace(follower.model(), options.filter); });
  }
  Progress progress(options);
  while (!progress.done()) {
    if (session.interrupted()) throw Interrupted{};
    if (Clock::now() >= end) {
      throw Failure(kExitTimeout, options.topic + ": " + progress.text() + " within " +
                                      seconds_text(*options.timeout_s));
    }
    follower.take(end, [&](const bus::RawSample& sample) {
      if (!filter || filter->matches(sample.cdr)) progress.add(sample);
    });
  }
  return runtime::kExitSuccess;
}

}  // namespace

void add_wait(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<WaitOptions>();
  CLI::App& command = *app.add_subcommand("wait", "wait for samples, in scripts");
  add_topic(command, options->topic);
  add_count(command, options->count, "so many samples (1)");
  command.add_option("--hz", options->hz, "until they arrive at least so often (to within 1 %)")
      ->check(CLI::Range(0.001, 1e6).description(""))
      ->type_name("MIN");
  command.add_option("--filter", options->filter,
                     "count only samples for which this holds; see echo");
  command.add_option("--timeout", options->timeout_s, "s to wait at most; else for ever")
      ->check(CLI::Range(0.01, 86400.0).description(""))
      ->type_name("S");
  command.footer(
      "Returns as soon as it is true, and prints nothing. Without --hz, samples that writers keep\n"
      "for late joiners count.\n"
      "Examples:\n"
      "  scarab-topic wait scarab/robot_state --timeout 10\n"
      "  scarab-topic wait scarab/robot_sensors --hz 35 --timeout 20\n"
      "  scarab-topic wait scarab/world_state --filter \"verdict <> 'VERDICT_OPEN'\"\n"
      "Exit codes: 0 true, 1 failed, 2 bad usage, 3 not true in time, 4 no such topic in time, 5 "
      "type\n"
      "unknown, 130 interrupted.");
  command.callback([&choice, options] {
    choice.run = [&choice, options] { return wait(choice.bus, *options); };
  });
}

}  // namespace scarab::topic
