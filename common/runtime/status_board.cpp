#include "common/runtime/status_board.hpp"

#include <algorithm>

#include "common/bus/sample_fields.hpp"

namespace scarab::runtime {
namespace {

ServiceReport report_of(const scarab_ServiceStatus& status) {
  ServiceReport report;
  report.peer = {status.service, status.instance};
  report.header = status.header;
  report.lifecycle = status.lifecycle;
  report.ready_trial = status.ready_trial;
  report.recorded_trial = status.recorded_trial;
  report.recorded_tick = status.recorded_tick;
  report.health = status.health;
  report.message = status.message;
  report.process_id = status.process_id;
  for (const auto& counter : bus::elements(status.counters)) {
    report.counters[counter.name] = counter.value;
  }
  for (const auto& histogram : bus::elements(status.histograms)) {
    Histogram::Counts counts{};
    std::copy(std::begin(histogram.count), std::end(histogram.count), counts.begin());
    report.histograms[histogram.name] = {counts, histogram.sum_s, histogram.max_s};
  }
  return report;
}

}  // namespace

StatusBoard::StatusBoard(bus::Participant& participant)
    : reader_(participant, bus::kServiceStatus) {}

void StatusBoard::update() {
  reader_.take_with_info([this](const scarab_ServiceStatus& status, const bus::SampleInfo& info) {
    const bus::Peer peer{status.service, status.instance};
    if (info.state != bus::InstanceState::kAlive) {
      reports_.erase(peer);
    } else if (info.valid) {
      reports_[peer] = report_of(status);
    }
  });
}

const ServiceReport* StatusBoard::find(const bus::Peer& peer) const {
  const auto entry = reports_.find(peer);
  return entry == reports_.end() ? nullptr : &entry->second;
}

std::vector<std::string> StatusBoard::missing(const Expectation& expect,
                                              std::uint32_t trial) const {
  std::vector<std::string> names;
  for (const auto& [service, count] : expect) {
    for (std::uint32_t instance = 0; instance < count; ++instance) {
      const auto* report = find({service, instance});
      if (!report || (trial != 0 && report->ready_trial != trial)) {
        names.push_back(service + "/" + std::to_string(instance));
      }
    }
  }
  return names;
}

}  // namespace scarab::runtime
