#include "tests/interop/fastdds/status.hpp"

#include <unistd.h>

namespace scarab::fastdds {
namespace {

constexpr std::chrono::milliseconds kProgressPeriod{250};
constexpr std::chrono::milliseconds kRecordedPeriod{20};
constexpr std::uint32_t kRecordedTicks = 4;
// Half the topic's lease: who was starved for longer took this service for gone, and learns better.
constexpr std::chrono::milliseconds kRepeatPeriod{500};

}  // namespace

Status::Status(Node& node) : writer_(node, kServiceStatus) {
  status_.service(node.self().service);
  status_.instance(node.self().instance);
  status_.process_id(static_cast<std::uint32_t>(::getpid()));
}

void Status::set_lifecycle(Lifecycle lifecycle) {
  changed_ = changed_ || status_.lifecycle() != lifecycle;
  status_.lifecycle(lifecycle);
}

void Status::set_ready(std::uint32_t trial) {
  changed_ = changed_ || status_.ready_trial() != trial;
  status_.ready_trial(trial);
}

void Status::set_health(Health health, const std::string& message) {
  if (status_.health() == health && status_.message().to_string() == message) return;
  status_.health(health);
  status_.message(eprosima::fastrtps::fixed_string<255>(message));
  changed_ = true;
}

void Status::set_progress(const Header& header) {
  status_.header(header);
  progressed_ = true;
}

void Status::set_recorded(std::uint32_t trial, std::uint32_t tick) {
  status_.header().trial(trial);
  status_.header().tick(tick);
  const bool new_trial = status_.recorded_trial() != trial;
  changed_ = changed_ || new_trial || tick >= reported_tick_ + kRecordedTicks;
  progressed_ = progressed_ || status_.recorded_tick() != tick;
  status_.recorded_trial(trial);
  status_.recorded_tick(tick);
}

void Status::publish_if_due() {
  const auto now = std::chrono::steady_clock::now();
  const bool recorded = status_.recorded_tick() != reported_tick_;
  const bool due = progressed_ && now - last_ >= (recorded ? kRecordedPeriod : kProgressPeriod);
  if (!changed_ && !due && now - last_ < kRepeatPeriod) return;
  status_.header().stamp_ns(now_ns());
  writer_.write(status_);
  reported_tick_ = status_.recorded_tick();
  changed_ = progressed_ = false;
  last_ = now;
}

std::int64_t now_ns() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

}  // namespace scarab::fastdds
