#pragma once

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// Looks on from beside the stack: how far the trial has come.
class View {
 public:
  explicit View(std::uint32_t domain = 0) : participant_(on_domain(domain)) {}

  /// The newest tick; -1 before the first.
  std::int64_t tick() {
    states_.take([this](const scarab_RobotState& state) { tick_ = state.header.tick; });
    return tick_;
  }
  /// Until the trial has come to `tick`.
  bool await_tick(std::int64_t wanted) {
    return eventually([&] { return tick() >= wanted; });
  }

 private:
  static bus::ParticipantOptions on_domain(std::uint32_t domain) {
    auto options = test_options("view");
    options.domain = domain;
    return options;
  }

  bus::Participant participant_;
  bus::Reader<scarab_RobotState> states_{participant_, bus::kRobotState};
  std::int64_t tick_ = -1;
};

}  // namespace scarab::test
