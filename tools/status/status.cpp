#include "tools/status/status.hpp"

#include <chrono>
#include <iostream>

#include "common/bus/waitset.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"

namespace scarab::status {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPoll{20};
constexpr std::chrono::milliseconds kDiscovery{1000};  // nobody can say that there is nobody

/// What is not as it should be with the services waited for.
std::vector<std::string> troubles(const runtime::StatusBoard& board,
                                  const runtime::Expectation& wait_for) {
  auto troubles = board.missing(wait_for, 0);
  for (auto& name : troubles) name += " is missing";
  for (const auto& [peer, report] : board.reports()) {
    if (wait_for.count(peer.service) == 0) continue;
    if (report.health == scarab_HEALTH_FAULT) {
      troubles.push_back(bus::to_string(peer) + ": " + report.message);
    } else if (report.lifecycle != scarab_LIFECYCLE_INACTIVE &&
               report.lifecycle != scarab_LIFECYCLE_ACTIVE) {
      troubles.push_back(bus::to_string(peer) + " is not configured");
    }
  }
  return troubles;
}

}  // namespace

int show(const StatusOptions& options) {
  bus::Participant participant(options.bus.participant("status", 0));
  runtime::StatusBoard board(participant);
  bus::Guard guard(participant);
  runtime::Shutdown shutdown(guard);
  bus::WaitSet wait_set(participant);
  wait_set.attach(board.reader());
  wait_set.attach(guard);

  const bool waiting = !options.wait_for.empty();
  const auto limit = waiting ? std::chrono::duration<double>(options.timeout_s)
                             : std::chrono::duration<double>(kDiscovery);
  const auto since = Clock::now();
  while (!shutdown.requested() && Clock::now() - since < limit) {
    wait_set.wait(kPoll);
    board.update();
    if (waiting && troubles(board, options.wait_for).empty()) break;
  }
  std::cout << (options.json ? json(board) : table(board));
  if (waiting) {
    const auto left = troubles(board, options.wait_for);
    if (left.empty()) return runtime::kExitSuccess;
    std::cerr << "scarab-status: " << runtime::join(left) << '\n';
    return runtime::kExitFailure;
  }
  if (board.reports().empty()) std::cerr << "scarab-status: no services found\n";
  return board.reports().empty() ? runtime::kExitFailure : runtime::kExitSuccess;
}

}  // namespace scarab::status
