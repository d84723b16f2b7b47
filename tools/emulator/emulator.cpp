#include "tools/emulator/emulator.hpp"

#include <poll.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "common/bus/error.hpp"
#include "common/runtime/real_time_care.hpp"
#include "services/plant/adapter.hpp"
#include "tools/emulator/boards/make_board.hpp"
#include "tools/emulator/bus_side.hpp"
#include "tools/emulator/control_pipe.hpp"
#include "tools/emulator/faults/fault_plan.hpp"
#include "tools/emulator/faults/fault_text.hpp"
#include "tools/emulator/journal.hpp"
#include "tools/emulator/stop_signals.hpp"
#include "tools/emulator/wire/wire.hpp"
#include "tools/emulator/world/world.hpp"

namespace scarab::emulator {
namespace {

constexpr double kNsPerS = 1e9;
/// The bus is looked at no less often than this.
constexpr std::int64_t kLongestSleepNs = 5'000'000;
/// So often a world that stands still is shown again, to whoever has come to see it.
constexpr std::int64_t kStillPeriodNs = 1'000'000'000;
constexpr std::int64_t kBetweenReportsNs = 1'000'000'000;  // of a computer that is too slow

std::int64_t now_ns() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

class Emulator {
 public:
  Emulator(const EmulatorOptions& options, const Configuration& configuration);
  void run();

 private:
  void pass(std::int64_t now);
  void take_trial();
  void take_orders(std::int64_t now);
  void update_faults(std::int64_t now);
  void move_world(std::int64_t now);
  void show_still_world(std::int64_t now);
  void publish();
  void report_lateness(std::int64_t now);
  bool sleep();  // false: a signal came

  Journal journal_;
  std::unique_ptr<Board> board_;
  World world_;
  FaultPlan faults_;
  Effects effects_;
  Wire wire_;
  ControlPipe control_;
  BusSide bus_;
  StopSignals signals_;
  std::int64_t control_period_ns_;
  std::uint64_t power_ups_ = 0;  // when the world was built
  std::uint64_t reported_lateness_ = 0;
  std::int64_t next_report_ns_ = 0;
  std::int64_t next_show_ns_ = 0;
};

Emulator::Emulator(const EmulatorOptions& options, const Configuration& configuration)
    : journal_(options.journal),
      board_(make_board(configuration.bridge, configuration.robot, configuration.calibration,
                        [this](std::string_view event, const std::string& detail) {
                          journal_.note(event, detail);
                        })),
      world_(configuration.robot, configuration.plant, configuration.bridge.timing.sensor_period_s),
      wire_(options.device, options.no_bus_rate ? 0 : board_->baud(), options.seed),
      control_(options.control),
      bus_(options.service.bus.participant("emulator", options.service.instance)),
      control_period_ns_(std::llround(configuration.bridge.timing.control_period_s * kNsPerS)) {
  for (const Fault& fault : options.faults) {
    faults_.add(fault, static_cast<double>(now_ns()) / kNsPerS);
  }
  board_->sense(world_.observe());
  spdlog::info(
      "{}: {} at {}", options.device.string(), board_->description(),
      options.no_bus_rate ? "no particular rate" : std::to_string(board_->baud()) + " baud");
  if (!options.control.empty()) {
    spdlog::info("takes faults: scarab-emulator tell {} WORDS", options.control.string());
  }
}

void Emulator::run() {
  // It stands in for hardware, which answers in time whatever else the computer does.
  const runtime::RealTimeCare care = runtime::take_real_time_care();
  if (!care.priority_raised) spdlog::warn("{}", care.priority_refusal);
  // The kernel may else wake us up to 50 us late to save a wake-up: five bytes of a fast bus.
  ::prctl(PR_SET_TIMERSLACK, 1UL, 0, 0, 0);
  do {
    pass(now_ns());
  } while (sleep());
  const Lateness& late = world_.lateness();
  spdlog::info("stopped; time that the world has left out: {:.3f} s in {} places",
               static_cast<double>(late.lost_ns) / kNsPerS, late.count);
}

void Emulator::pass(std::int64_t now) {
  take_orders(now);
  update_faults(now);
  take_trial();
  move_world(now);
  wire_.carry_in(now, *board_);
  // What has been waiting for this computer is not too late for a watchdog.
  if (!wire_.is_carrying_in()) board_->tick(now);
  if (!world_.runs() && board_->power_ups() != power_ups_) {
    world_.start(now);
    journal_.note("world_runs", "");
  }
  wire_.carry_out(now);
  show_still_world(now);
  report_lateness(now);
  journal_.flush();
}

void Emulator::take_trial() {
  const auto trial = bus_.take_trial();
  if (!trial) return;
  robot::JointVector start_rad = world_.configured_start_rad();
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    start_rad[j] = effects_.pose_rad[j].value_or(start_rad[j]);
  }
  try {
    world_.build(plant::to_trial_spec(*trial), start_rad);
  } catch (const std::invalid_argument& error) {
    spdlog::error("trial {}: {}; the world stays as it is", trial->header.trial, error.what());
    return;
  }
  journal_.note("trial", std::to_string(trial->header.trial));
  spdlog::info("trial {}: the world is built anew and stands still until a servo has power",
               trial->header.trial);
  board_->put_back();
  board_->sense(world_.observe());
  power_ups_ = board_->power_ups();
  next_show_ns_ = 0;
}

void Emulator::take_orders(std::int64_t now) {
  for (const std::string& line : control_.read()) {
    try {
      const FaultOrder order = parse_fault_order(line);
      if (const auto* fault = std::get_if<Fault>(&order)) {
        faults_.add(*fault, static_cast<double>(now) / kNsPerS);
      } else {
        faults_.clear();
      }
    } catch (const std::invalid_argument& error) {
      spdlog::warn("an order that is none: {}", error.what());
    }
  }
}

void Emulator::update_faults(std::int64_t now) {
  std::optional<double> world_s;
  if (world_.runs()) world_s = static_cast<double>(world_.time_ns()) / kNsPerS;
  const auto changes = faults_.update(static_cast<double>(now) / kNsPerS, world_s);
  if (!changes.any()) return;
  for (const Fault& fault : changes.began) {
    journal_.note("fault_on", to_text(fault));
    spdlog::info("fault: {}", to_text(fault));
  }
  for (const Fault& fault : changes.ended) {
    journal_.note("fault_off", to_text(fault));
    spdlog::info("no fault any more: {}", to_text(fault));
  }
  effects_ = effects_of(faults_.active());
  wire_.suffer(effects_);
  board_->suffer(effects_);
  board_->sense(world_.observe());
}

void Emulator::move_world(std::int64_t now) {
  if (!world_.runs() || world_.next_step_ns() > now) return;
  try {
    world_.advance(now, board_->drive(), effects_.stuck, [this] { publish(); });
  } catch (const std::runtime_error& error) {
    journal_.note("world_broken", "");
    spdlog::error("{}; the world stands still until the next trial", error.what());
  }
  board_->sense(world_.observe());
}

void Emulator::show_still_world(std::int64_t now) {
  if (world_.runs() || !bus_.has_trial() || now < next_show_ns_) return;
  next_show_ns_ = now + kStillPeriodNs;
  publish();
}

void Emulator::publish() {
  const std::int64_t time_ns = world_.time_ns();
  try {
    bus_.publish(static_cast<std::uint32_t>(time_ns / control_period_ns_), time_ns, world_.truth());
  } catch (const bus::Error& error) {
    spdlog::warn("{}", error.what());
  }
}

void Emulator::report_lateness(std::int64_t now) {
  const Lateness& late = world_.lateness();
  if (late.count == reported_lateness_ || now < next_report_ns_) return;
  reported_lateness_ = late.count;
  next_report_ns_ = now + kBetweenReportsNs;
  journal_.note("late", std::to_string(late.lost_ns));
  spdlog::warn("this computer was too slow: the world has left out {:.3f} s so far, in {} places",
               static_cast<double>(late.lost_ns) / kNsPerS, late.count);
}

bool Emulator::sleep() {
  const std::int64_t now = now_ns();
  std::int64_t wake_ns = now + kLongestSleepNs;
  if (!wire_.is_carrying_in()) wake_ns = std::min(wake_ns, board_->next_tick_ns());
  if (world_.runs()) wake_ns = std::min(wake_ns, world_.next_step_ns());
  if (const auto wire_ns = wire_.next_ns()) wake_ns = std::min(wake_ns, *wire_ns);
  const std::int64_t left_ns = std::max<std::int64_t>(0, wake_ns - now);
  const timespec left{0, static_cast<long>(left_ns)};
  // A negative descriptor is passed over: an unplugged device, no control pipe.
  std::array<pollfd, 3> watched = {
      {{signals_.fd(), POLLIN, 0}, {wire_.fd(), POLLIN, 0}, {control_.fd(), POLLIN, 0}}};
  (void)::ppoll(watched.data(), watched.size(), &left, nullptr);
  return watched[0].revents == 0;
}

}  // namespace

void emulate(const EmulatorOptions& options, const Configuration& configuration) {
  Emulator(options, configuration).run();
}

}  // namespace scarab::emulator
