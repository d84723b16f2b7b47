#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/runtime/expectation.hpp"
#include "common/runtime/histogram.hpp"

namespace scarab::runtime {

/// One service's last word of itself.
struct ServiceReport {
  bus::Peer peer;
  scarab_Header header{};
  scarab_Lifecycle lifecycle = scarab_LIFECYCLE_UNCONFIGURED;
  std::uint32_t ready_trial = 0;
  std::uint32_t recorded_trial = 0;
  std::uint32_t recorded_tick = 0;
  scarab_Health health = scarab_HEALTH_OK;
  std::string message;
  std::uint32_t process_id = 0;
  std::map<std::string, std::uint64_t> counters;
  std::map<std::string, Histogram> histograms;
};

/// What all living services say of themselves.
class StatusBoard {
 public:
  explicit StatusBoard(bus::Participant& participant);

  /// Takes in what has arrived; services that ended or died leave the board.
  void update();
  [[nodiscard]] bus::Reader<scarab_ServiceStatus>& reader() { return reader_; }
  [[nodiscard]] const std::map<bus::Peer, ServiceReport>& reports() const { return reports_; }
  [[nodiscard]] const ServiceReport* find(const bus::Peer& peer) const;

  /// Expected instances that are not on the board, or not ready for `trial` (0: any), each as
  /// `premotor/0`.
  [[nodiscard]] std::vector<std::string> missing(const Expectation& expect,
                                                 std::uint32_t trial) const;

 private:
  bus::Reader<scarab_ServiceStatus> reader_;
  std::map<bus::Peer, ServiceReport> reports_;
};

}  // namespace scarab::runtime
