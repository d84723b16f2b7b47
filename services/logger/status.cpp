#include "services/logger/status.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"

namespace scarab::logger {

RecorderStatus::RecorderStatus(bus::Participant& participant, const bus::Peer& self)
    : service_(self.service), writer_(participant, bus::kServiceStatus) {
  bus::borrow(status_.service, service_);
  status_.instance = self.instance;
  status_.process_id = static_cast<std::uint32_t>(::getpid());
}

void RecorderStatus::set_lifecycle(scarab_Lifecycle lifecycle) {
  changed_ = changed_ || status_.lifecycle != lifecycle;
  status_.lifecycle = lifecycle;
}

void RecorderStatus::set_ready(std::uint32_t trial) {
  changed_ = changed_ || status_.ready_trial != trial;
  status_.ready_trial = trial;
}

void RecorderStatus::set_health(scarab_Health health, const std::string& message) {
  if (status_.health == health && bus::text(status_.message) == message) return;
  status_.health = health;
  bus::assign_truncated(status_.message, message);
  changed_ = true;
  if (message.empty()) return;
  spdlog::log(health == scarab_HEALTH_FAULT      ? spdlog::level::err
              : health == scarab_HEALTH_DEGRADED ? spdlog::level::warn
                                                 : spdlog::level::info,
              "{}", message);
}

void RecorderStatus::set_recorded(const RecordedProgress& progress) {
  status_.recorded_trial = progress.trial();
  status_.recorded_tick = progress.tick();
  status_.header.trial = progress.trial();
  status_.header.tick = progress.tick();
}

void RecorderStatus::set_counter(const std::string& name, std::uint64_t value) {
  auto [entry, fresh] = counters_.try_emplace(name, value);
  counted_ = counted_ || fresh || entry->second != value;
  entry->second = value;
}

/// From the last report to the next.
std::chrono::nanoseconds RecorderStatus::due_after() const {
  const bool new_trial = status_.recorded_trial != reported_trial_;
  const bool moved = new_trial || status_.recorded_tick != reported_tick_;
  if (changed_ || new_trial || (moved && status_.recorded_tick >= reported_tick_ + kReportTicks)) {
    return std::chrono::nanoseconds(0);
  }
  return moved ? kReportDelay : kIdlePeriod;
}

std::chrono::nanoseconds RecorderStatus::time_left() const {
  return std::max(Clock::duration(0), last_ + due_after() - Clock::now());
}

void RecorderStatus::publish_if_due() {
  const auto due = due_after();
  if (Clock::now() - last_ < due || (due == kIdlePeriod && !counted_)) return;
  publish();
}

void RecorderStatus::publish() {
  std::vector<scarab_Counter> counters(counters_.size());
  auto counter = counters.begin();
  for (const auto& [name, value] : counters_) {
    bus::assign_truncated(counter->name, name);
    counter->value = value;
    ++counter;
  }
  bus::borrow(status_.counters, counters);
  status_.header.stamp_ns = bus::now_ns();
  writer_.write(status_);
  status_.counters = {};
  reported_trial_ = status_.recorded_trial;
  reported_tick_ = status_.recorded_tick;
  changed_ = counted_ = false;
  last_ = Clock::now();
}

}  // namespace scarab::logger
