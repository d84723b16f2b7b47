#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "services/robot_bridge/core/driver.hpp"

namespace scarab::bridge {

/// Notes what it is told; fails where it is told to.
class NotingDriver : public Driver {
 public:
  void open() override { note("open"); }
  void close() noexcept override { calls.emplace_back("close"); }
  Readings read() override {
    note("read");
    return readings;
  }
  void activate(const robot::JointVector& hold_rad) override {
    held_rad = hold_rad;
    note("activate");
  }
  void write(const robot::JointVector& target_rad) override {
    written_rad = target_rad;
    note("write");
  }
  bool hold() noexcept override { return stop("hold"); }
  bool release() noexcept override { return stop("release"); }
  [[nodiscard]] Capabilities capabilities() const override {
    Capabilities capabilities;
    capabilities.torque_switch = has_switch;
    return capabilities;
  }
  [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> counters() const override {
    return {};
  }

  std::vector<std::string> calls;
  std::string fails;         // the call that throws
  bool fails_oddly = false;  // with another exception than a driver should
  bool stops = true;         // hold() and release() are confirmed
  bool has_switch = true;
  Readings readings;  // what it reads
  robot::JointVector held_rad{};
  robot::JointVector written_rad{};

 private:
  void note(const std::string& call) {
    calls.push_back(call);
    if (call != fails) return;
    if (fails_oddly) throw std::runtime_error("something odd in " + call);
    throw DeviceError("no answer to " + call);
  }
  bool stop(const char* call) noexcept {
    calls.emplace_back(call);
    return stops;
  }
};

}  // namespace scarab::bridge
