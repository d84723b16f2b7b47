#include "tools/emulator/emulator.hpp"

#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/bus/error.hpp"
#include "services/plant/adapter.hpp"
#include "tools/emulator/bus_side.hpp"
#include "tools/emulator/control_pipe.hpp"
#include "tools/emulator/faults/fault_text.hpp"
#include "tools/emulator/journal.hpp"
#include "tools/emulator/robot.hpp"
#include "tools/emulator/robot_thread.hpp"
#include "tools/emulator/stop_signals.hpp"

namespace scarab::emulator {
namespace {

constexpr double kNsPerS = 1e9;
/// The bus is looked at no less often than this.
constexpr int kLongestSleepMs = 5;

/// Before the rest of the computer, too, but never before the robot: a trial that comes late to the
/// world would have missed its start. Refused where the robot's priority is, which has said so.
void go_before_others() {
  sched_param parameters{};
  parameters.sched_priority = 1;
  (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

/// All around the robot that may take its time: the bus, the journal, the log, and who gives it
/// faults.
class Laboratory {
 public:
  Laboratory(const EmulatorOptions& options, const Configuration& configuration);
  void run();

 private:
  void take_trial();
  void take_faults();
  bool take_report();  // false: the robot has ended
  void tell(const Event& event);
  void publish(const Sight& sight);
  bool sleep();  // false: a signal came

  Mailbox<Orders> orders_;
  Mailbox<Report> reports_;
  Robot robot_;  // before the files: who may not have the device leaves those of its owner alone
  Journal journal_;
  ControlPipe control_;
  BusSide bus_;
  StopSignals signals_;
  std::int64_t control_period_ns_;
  Pose pose_{};
};

Laboratory::Laboratory(const EmulatorOptions& options, const Configuration& configuration)
    : robot_(options, configuration, orders_, reports_),
      journal_(options.journal),
      control_(options.control),
      bus_(options.service.bus.participant("emulator", options.service.instance)),
      control_period_ns_(std::llround(configuration.bridge.timing.control_period_s * kNsPerS)) {
  spdlog::info("{}: {}", options.device.string(), robot_.description());
  if (!options.control.empty()) {
    spdlog::info("takes faults: scarab-emulator tell {} WORDS", options.control.string());
  }
}

void Laboratory::run() {
  RobotThread thread(robot_, orders_, reports_);
  go_before_others();
  do {
    take_faults();
    take_trial();
  } while (take_report() && sleep());
  thread.end();
  (void)take_report();
  const Lateness& late = robot_.lateness();
  spdlog::info("stopped; time that the world has left out: {:.3f} s in {} places",
               static_cast<double>(late.lost_ns) / kNsPerS, late.count);
}

void Laboratory::take_trial() {
  const auto trial = bus_.take_trial();
  if (!trial) return;
  try {
    auto world = robot_.build_world(plant::to_trial_spec(*trial), pose_);
    orders_.put([&](Orders& orders) {
      orders.trial = trial->header.trial;
      orders.world = std::move(world);
    });
  } catch (const std::invalid_argument& error) {
    spdlog::error("trial {}: {}; the world stays as it is", trial->header.trial, error.what());
  }
}

void Laboratory::take_faults() {
  for (const std::string& line : control_.read()) {
    try {
      const FaultOrder order = parse_fault_order(line);
      orders_.put([&](Orders& orders) { orders.faults.push_back(order); });
    } catch (const std::invalid_argument& error) {
      spdlog::warn("an order that is none: {}", error.what());
    }
  }
}

bool Laboratory::take_report() {
  const Report report = reports_.take();
  if (report.pose) pose_ = *report.pose;
  for (const Sight& sight : report.sights) publish(sight);
  for (const Event& event : report.events) tell(event);
  journal_.flush();
  return !report.ended;
}

void Laboratory::tell(const Event& event) {
  journal_.note(event.stamp_ns, event.name, event.detail);
  if (event.name == "fault_on") {
    spdlog::info("fault: {}", event.detail);
  } else if (event.name == "fault_off") {
    spdlog::info("no fault any more: {}", event.detail);
  } else if (event.name == "trial") {
    spdlog::info("trial {}: the world is built anew and stands still until a servo has power",
                 event.detail);
  } else if (event.name == "world_broken") {
    spdlog::error(
        "the robot's motion is no longer finite; the world stands still until the next trial");
  } else if (event.name == "late") {
    spdlog::warn("this computer was too slow: the world has left out {:.3f} s so far",
                 std::stod(event.detail) / kNsPerS);
  }
}

void Laboratory::publish(const Sight& sight) {
  try {
    bus_.publish(sight.trial, static_cast<std::uint32_t>(sight.time_ns / control_period_ns_),
                 sight.time_ns, sight.truth);
  } catch (const bus::Error& error) {
    spdlog::warn("{}", error.what());
  }
}

bool Laboratory::sleep() {
  // A negative descriptor is passed over: no control pipe.
  std::array<pollfd, 3> watched = {
      {{signals_.fd(), POLLIN, 0}, {reports_.fd(), POLLIN, 0}, {control_.fd(), POLLIN, 0}}};
  (void)::poll(watched.data(), watched.size(), kLongestSleepMs);
  return watched[0].revents == 0;
}

}  // namespace

void emulate(const EmulatorOptions& options, const Configuration& configuration) {
  Laboratory(options, configuration).run();
}

}  // namespace scarab::emulator
