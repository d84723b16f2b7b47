#include "services/plant/core/command_delay.hpp"

#include "common/random/random.hpp"
#include "services/plant/core/timing.hpp"

namespace scarab::plant {
namespace {

constexpr std::uint64_t kJitter = random::stream("command jitter");

}  // namespace

CommandDelay::CommandDelay(const CommandPathConfig& config, std::uint64_t seed,
                           std::int64_t step_ns, const robot::JointVector& initial_rad)
    : seed_(seed),
      latency_steps_(whole_steps(config.latency_s, step_ns, "commands latency_s")),
      jitter_steps_(whole_steps(config.jitter_s, step_ns, "commands jitter_s")),
      target_rad_(initial_rad) {}

void CommandDelay::send(std::uint64_t k, std::int64_t step, const robot::JointVector& target_rad) {
  const double u = random::uniform(seed_, kJitter, k);
  const auto jitter = static_cast<std::int64_t>(u * static_cast<double>(jitter_steps_ + 1));
  const std::int64_t arrival = step + latency_steps_ + jitter;
  while (!under_way_.empty() && under_way_.back().arrival_step >= arrival) under_way_.pop_back();
  under_way_.push_back({arrival, target_rad});
}

const robot::JointVector& CommandDelay::arrived_at(std::int64_t step) {
  while (!under_way_.empty() && under_way_.front().arrival_step <= step) {
    target_rad_ = under_way_.front().target_rad;
    under_way_.pop_front();
  }
  return target_rad_;
}

}  // namespace scarab::plant
