#include "tools/emulator/robot.hpp"

#include <poll.h>
#include <sys/prctl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "common/bus/clock.hpp"
#include "tools/emulator/boards/make_board.hpp"
#include "tools/emulator/faults/fault_text.hpp"

namespace scarab::emulator {
namespace {

constexpr double kNsPerS = 1e9;
/// So often a world that stands still is shown again, to whoever has come to see it.
constexpr std::int64_t kStillPeriodNs = 1'000'000'000;
constexpr std::int64_t kBetweenNotesNs = 1'000'000'000;  // of a computer that is too slow
/// Faults that end by the wall clock are looked for no less often than this.
constexpr std::int64_t kLongestSleepNs = 5'000'000;

std::int64_t now_ns() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

double to_s(std::int64_t ns) { return static_cast<double>(ns) / kNsPerS; }

template <class T>
void append(std::vector<T>& all, std::vector<T>&& more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

Robot::Robot(const EmulatorOptions& options, const Configuration& configuration,
             Mailbox<Orders>& orders, Mailbox<Report>& reports)
    : orders_(orders),
      reports_(reports),
      board_(make_board(
          configuration.bridge, configuration.robot, configuration.calibration,
          [this](std::string_view event, const std::string& detail) { note(event, detail); })),
      baud_(options.no_bus_rate ? 0 : board_->baud()),
      world_(configuration.robot, configuration.plant, configuration.bridge.timing.sensor_period_s),
      wire_(options.device, baud_, options.seed) {
  for (const Fault& fault : options.faults) faults_.add(fault, to_s(now_ns()));
  board_->sense(world_.observe());
}

std::string Robot::description() const {
  return board_->description() + " at " +
         (baud_ == 0 ? "no particular rate" : std::to_string(baud_) + " baud");
}

std::unique_ptr<plant::Simulation> Robot::build_world(const plant::TrialSpec& trial,
                                                      const Pose& pose) const {
  robot::JointVector start_rad = world_.configured_start_rad();
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    start_rad[j] = pose[j].value_or(start_rad[j]);
  }
  return world_.prepare(trial, start_rad);
}

void Robot::run() {
  // The kernel may else wake us up to 50 us late to save a wake-up: five bytes of a fast bus.
  ::prctl(PR_SET_TIMERSLACK, 1UL, 0, 0, 0);
  while (take_orders(now_ns())) {
    pass(now_ns());
    sleep();
  }
}

void Robot::pass(std::int64_t now) {
  update_faults(now);
  move_world(now);
  wire_.carry_in(now, *board_);
  // What has been waiting for this computer is not too late for a watchdog.
  if (!wire_.is_carrying_in()) board_->tick(now);
  if (!world_.runs() && board_->power_ups() != power_ups_) {
    world_.start(now);
    note("world_runs", "");
  }
  wire_.carry_out(now);
  show_still_world(now);
  note_lateness(now);
  send_report();
}

bool Robot::take_orders(std::int64_t now) {
  Orders orders = orders_.take();
  for (const FaultOrder& order : orders.faults) {
    if (const auto* fault = std::get_if<Fault>(&order)) {
      faults_.add(*fault, to_s(now));
    } else {
      faults_.clear();
    }
  }
  if (orders.world) enter(orders.trial, std::move(orders.world));
  return !orders.end;
}

void Robot::enter(std::uint32_t trial, std::unique_ptr<plant::Simulation> world) {
  report_.old_world = world_.replace(std::move(world));
  trial_ = trial;
  note("trial", std::to_string(trial));
  board_->put_back();
  board_->sense(world_.observe());
  power_ups_ = board_->power_ups();
  next_show_ns_ = 0;
}

void Robot::update_faults(std::int64_t now) {
  std::optional<double> world_s;
  if (world_.runs()) world_s = to_s(world_.time_ns());
  const auto changes = faults_.update(to_s(now), world_s);
  if (!changes.any()) return;
  for (const Fault& fault : changes.began) note("fault_on", to_text(fault));
  for (const Fault& fault : changes.ended) note("fault_off", to_text(fault));
  effects_ = effects_of(faults_.active());
  report_.pose = effects_.pose_rad;
  wire_.suffer(effects_);
  board_->suffer(effects_);
  board_->sense(world_.observe());
}

void Robot::move_world(std::int64_t now) {
  if (!world_.runs() || world_.next_step_ns() > now) return;
  try {
    world_.advance(now, board_->drive(), effects_.stuck, [this] { show(); });
  } catch (const std::runtime_error&) {
    note("world_broken", "");
  }
  board_->sense(world_.observe());
}

void Robot::show_still_world(std::int64_t now) {
  if (world_.runs() || trial_ == 0 || now < next_show_ns_) return;
  next_show_ns_ = now + kStillPeriodNs;
  show();
}

void Robot::show() { report_.sights.push_back({trial_, world_.time_ns(), world_.truth()}); }

void Robot::note(std::string_view event, const std::string& detail) {
  report_.events.push_back({bus::now_ns(), std::string(event), detail});
}

void Robot::note_lateness(std::int64_t now) {
  const Lateness& late = world_.lateness();
  if (late.count == noted_lateness_ || now < next_note_ns_) return;
  noted_lateness_ = late.count;
  next_note_ns_ = now + kBetweenNotesNs;
  note("late", std::to_string(late.lost_ns));
}

void Robot::send_report() {
  if (report_.is_empty()) return;
  reports_.put([this](Report& waiting) {
    append(waiting.events, std::move(report_.events));
    append(waiting.sights, std::move(report_.sights));
    if (report_.pose) waiting.pose = report_.pose;
    if (report_.old_world) waiting.old_world = std::move(report_.old_world);
  });
  report_ = {};
}

void Robot::sleep() {
  const std::int64_t now = now_ns();
  std::int64_t wake_ns = now + kLongestSleepNs;
  if (!wire_.is_carrying_in()) wake_ns = std::min(wake_ns, board_->next_tick_ns());
  if (world_.runs()) wake_ns = std::min(wake_ns, world_.next_step_ns());
  if (const auto wire_ns = wire_.next_ns()) wake_ns = std::min(wake_ns, *wire_ns);
  const std::int64_t left_ns = std::max<std::int64_t>(0, wake_ns - now);
  const timespec left{0, static_cast<long>(left_ns)};
  // A negative descriptor is passed over: an unplugged device.
  std::array<pollfd, 2> watched = {{{orders_.fd(), POLLIN, 0}, {wire_.fd(), POLLIN, 0}}};
  (void)::ppoll(watched.data(), watched.size(), &left, nullptr);
}

}  // namespace scarab::emulator
