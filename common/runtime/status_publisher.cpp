#include "common/runtime/status_publisher.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"

namespace scarab::runtime {

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
  if (status_.health == health && message == status_.message) return;
  status_.health = health;
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

void StatusPublisher::set_counter(const std::string& name, std::uint64_t value) {
  auto [entry, fresh] = counters_.try_emplace(name, 0);
  if (!fresh && entry->second == value) return;
  entry->second = value;
  progressed_ = true;
}

void StatusPublisher::publish_if_due() {
  const auto now = std::chrono::steady_clock::now();
  if (changed_ || (progressed_ && now - last_ >= kProgressPeriod)) {
    last_ = now;
    publish();
  }
}

void StatusPublisher::publish() {
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
  changed_ = false;
  progressed_ = false;
}

}  // namespace scarab::runtime
