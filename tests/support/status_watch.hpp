#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "common/runtime/status_board.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// What the services of the running test say of themselves.
class StatusWatch {
 public:
  using Report = runtime::ServiceReport;

  /// The report of a service once `condition(report)` holds; nothing after `limit`.
  template <class Condition>
  std::optional<Report> await(const bus::Peer& peer, Condition&& condition,
                              std::chrono::milliseconds limit = kPatience) {
    std::optional<Report> found;
    eventually(
        [&] {
          board_.update();
          const auto* report = board_.find(peer);
          if (report && condition(*report)) found = *report;
          return found.has_value();
        },
        limit);
    return found;
  }
  /// Until it says ready(trial), as process `pid` where that is given.
  bool await_ready(const bus::Peer& peer, std::uint32_t trial, pid_t pid = 0) {
    return await(peer,
                 [&](const Report& report) {
                   return report.ready_trial == trial &&
                          (pid == 0 || report.process_id == static_cast<std::uint32_t>(pid));
                 })
        .has_value();
  }
  std::optional<Report> await_health(const bus::Peer& peer, scarab_Health health) {
    return await(peer, [&](const Report& report) { return report.health == health; });
  }
  std::optional<Report> await_message(const bus::Peer& peer, const std::string& part,
                                      std::chrono::milliseconds limit = kPatience) {
    return await(
        peer, [&](const Report& report) { return report.message.find(part) != std::string::npos; },
        limit);
  }
  bool await_gone(const bus::Peer& peer) {
    return eventually([&] {
      board_.update();
      return board_.find(peer) == nullptr;
    });
  }

 private:
  bus::Participant participant_{test_options("watch")};
  runtime::StatusBoard board_{participant_};
};

}  // namespace scarab::test
