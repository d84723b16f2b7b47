#include "common/runtime/status_publisher.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"

namespace scarab::runtime {
namespace {

constexpr std::size_t kCountersMost = 64;  // bound of ServiceStatus.counters

}  // namespace

StatusPublisher::StatusPublisher(bus::Participant& participant, const bus::Peer& self)
    : service_(self.service), writer_(participant, bus::kServiceStatus) {
  bus::borrow(status_.service, service_);
  status_.instance = self.instance;
  status_.process_id = static_cast<std::uint32_t>(::getpid());
}

void StatusPublisher::set_lifecycle(scarab_Lifecycle lifecycle) {
  changed_ = changed_ || status_.lifecycle != lifecycle;
  status_.lifecycle = lifecycle;
}

void StatusPublisher::set_ready(std::uint32_t trial) {
  changed_ = changed_ || status_.ready_trial != trial;
  status_.ready_trial = trial;
}

void StatusPublisher::set_health(scarab_Health health, const std::string& message) {
  if (status_.health == health && message == message_) return;
  status_.health = health;
  message_ = message;
  bus::assign_truncated(status_.message, message);
  changed_ = true;
  if (message.empty()) return;
  spdlog::log(health == scarab_HEALTH_FAULT      ? spdlog::level::err
              : health == scarab_HEALTH_DEGRADED ? spdlog::level::warn
                                                 : spdlog::level::info,
              "{}", message);
}

void StatusPublisher::set_progress(const scarab_Header& header) {
  status_.header = header;
  progressed_ = true;
}

void StatusPublisher::set_recorded(std::uint32_t trial, std::uint32_t tick) {
  status_.recorded_trial = status_.header.trial = trial;
  status_.recorded_tick = status_.header.tick = tick;
}

void StatusPublisher::set_counter(const std::string& name, std::uint64_t value) {
  auto [entry, fresh] = counters_.try_emplace(name, 0);
  if (!fresh && entry->second == value) return;
  entry->second = value;
  progressed_ = true;
}

void StatusPublisher::set_histogram(const std::string& name, const Histogram& histogram) {
  histograms_[name] = histogram;
  progressed_ = true;
}

/// From the last report to the next.
std::chrono::nanoseconds StatusPublisher::due_after() const {
  const bool new_trial = status_.recorded_trial != reported_trial_;
  const bool recorded = new_trial || status_.recorded_tick != reported_tick_;
  if (changed_ || new_trial ||
      (recorded && status_.recorded_tick >= reported_tick_ + kRecordedTicks)) {
    return std::chrono::nanoseconds(0);
  }
  if (recorded) return kRecordedPeriod;
  return progressed_ ? kProgressPeriod : kRepeatPeriod;
}

std::chrono::nanoseconds StatusPublisher::time_left() const {
  return std::max(std::chrono::nanoseconds(0),
                  last_ + due_after() - std::chrono::steady_clock::now());
}

void StatusPublisher::publish_if_due() {
  if (std::chrono::steady_clock::now() - last_ >= due_after()) publish();
}

void StatusPublisher::publish() {
  std::vector<scarab_Counter> counters;
  for (const auto& [name, value] : counters_) {
    if (counters.size() == kCountersMost) break;  // a robot's long story is no reason to stop it
    scarab_Counter& counter = counters.emplace_back();
    bus::assign_truncated(counter.name, name);
    counter.value = value;
  }
  bus::borrow(status_.counters, counters);
  std::vector<scarab_Histogram> histograms(histograms_.size());
  auto to = histograms.begin();
  for (const auto& [name, histogram] : histograms_) {
    bus::assign_truncated(to->name, name);
    std::copy(histogram.counts().begin(), histogram.counts().end(), std::begin(to->count));
    to->sum_s = histogram.sum_s();
    to->max_s = histogram.max_s();
    ++to;
  }
  bus::borrow(status_.histograms, histograms);
  status_.header.stamp_ns = bus::now_ns();
  writer_.write(status_);
  status_.counters = {};
  status_.histograms = {};
  reported_trial_ = status_.recorded_trial;
  reported_tick_ = status_.recorded_tick;
  changed_ = progressed_ = false;
  last_ = std::chrono::steady_clock::now();
}

}  // namespace scarab::runtime
