#include "tools/emulator/boards/dynamixel/servo.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace scarab::emulator {
namespace {

constexpr double kNsPerS = 1e9;
/// How long a servo is away when it reboots: a reconstruction.
constexpr std::int64_t kRebootNs = 300'000'000;

}  // namespace

Servo::Servo(const dxl::ServoModel& model, const ServoPlace& place, Note note)
    : model_(model), place_(place), note_(std::move(note)), table_(servo_table(model, place.id)) {
  follow_goal();
}

std::string Servo::name() const { return std::string(robot::kJointNames.at(place_.joint)); }

bool Servo::is_awake(std::int64_t now_ns) const { return !is_silent_ && now_ns >= awake_from_ns_; }

dxl::PingAnswer Servo::ping() const { return {model_.model_number, kServoFirmware}; }

dxl::Status Servo::status(dxl::StatusError error) const {
  return {place_.id, table_.get(model_.hardware_error_status) != 0, error, {}};
}

dxl::Status Servo::read(dxl::Region region) const {
  auto data = table_.read(region);
  dxl::Status answer = status(data ? dxl::StatusError::kNone : dxl::StatusError::kAccess);
  if (data) answer.data = std::move(*data);
  return answer;
}

std::int64_t Servo::status_return_level() const { return table_.get(model_.status_return_level); }

std::int64_t Servo::return_delay_ns() const {
  return std::llround(static_cast<double>(table_.get(model_.return_delay)) *
                      model_.return_delay.unit * kNsPerS);
}

bool Servo::covers(const dxl::Item& item, std::uint16_t address, dxl::ByteView data) const {
  return address <= item.address && item.address + item.size() <= address + data.size();
}

dxl::StatusError Servo::check(std::uint16_t address, dxl::ByteView data) const {
  const auto error = table_.check(address, data, torque_is_on());
  if (error != dxl::StatusError::kNone) return error;
  if (covers(model_.goal_position, address, data)) {
    const bool stopped = table_.get(model_.bus_watchdog) == dxl::kBusWatchdogTripped;
    if (stopped) return dxl::StatusError::kDataRange;
    const auto goal =
        dxl::count_in(model_.goal_position,
                      data.slice(static_cast<std::size_t>(model_.goal_position.address - address),
                                 model_.goal_position.size()));
    if (goal < table_.get(model_.min_position_limit) ||
        goal > table_.get(model_.max_position_limit)) {
      return dxl::StatusError::kDataLimit;
    }
  }
  // After a shutdown only a reboot brings the torque back; which error a servo gives is not
  // published.
  if (covers(model_.torque_enable, address, data) &&
      table_.get(model_.hardware_error_status) != 0 &&
      data[static_cast<std::size_t>(model_.torque_enable.address - address)] != 0) {
    return dxl::StatusError::kResultFail;
  }
  return dxl::StatusError::kNone;
}

dxl::StatusError Servo::write(std::uint16_t address, dxl::ByteView data) {
  const auto error = check(address, data);
  if (error != dxl::StatusError::kNone) {
    note_("refused", fmt::format("{} address {}: {}", name(), address, dxl::name_of(error)));
    return error;
  }
  const bool had_torque = torque_is_on();
  const std::int64_t old_goal = table_.get(model_.goal_position);
  table_.write(address, data);
  if (table_.get(model_.goal_position) != old_goal) {
    note_("goal", fmt::format("{} {:.4f}", name(), joint_rad(table_.get(model_.goal_position))));
  }
  if (covers(model_.torque_enable, address, data)) {
    const bool on = torque_is_on();
    table_.set(model_.torque_enable, had_torque ? 1 : 0);  // set_torque() tells a change
    set_torque(on);
    if (on) ++power_ups_;
  }
  if (covers(model_.goal_position, address, data)) follow_goal();
  return error;
}

void Servo::set_torque(bool on) {
  if (on != torque_is_on()) note_(on ? "torque_on" : "torque_off", name());
  table_.set(model_.torque_enable, on ? 1 : 0);
  if (on) follow_goal();
}

double Servo::joint_rad(std::int64_t ticks) const {
  const double servo_rad =
      static_cast<double>(ticks - model_.centre_ticks) * model_.goal_position.unit;
  return bridge::to_joint_rad(place_.calibration, servo_rad);
}

void Servo::follow_goal() { target_rad_ = joint_rad(table_.get(model_.goal_position)); }

void Servo::reboot(std::int64_t now_ns) {
  note_("reboot", name());
  set_torque(false);
  table_.reset_ram();
  follow_goal();
  awake_from_ns_ = now_ns + kRebootNs;
  sense(motion_);
}

void Servo::hear(std::int64_t now_ns) { heard_ns_ = now_ns; }

std::optional<std::int64_t> Servo::watchdog_ns() const {
  const std::int64_t count = table_.get(model_.bus_watchdog);
  if (count <= 0 || !torque_is_on()) return std::nullopt;
  const double time_s = static_cast<double>(count) * model_.bus_watchdog.unit;
  return heard_ns_ + std::llround(time_s * kNsPerS);
}

void Servo::tick(std::int64_t now_ns) {
  const auto due_ns = watchdog_ns();
  if (!due_ns || now_ns <= *due_ns) return;
  table_.set(model_.bus_watchdog, dxl::kBusWatchdogTripped);
  target_rad_ = motion_.position_rad;
  note_("watchdog", name());
}

void Servo::sense(const JointMotion& joint) {
  motion_ = joint;
  const auto& c = place_.calibration;
  const double servo_rad = c.offset_rad + bridge::turned(c, joint.position_rad);
  table_.set(model_.present_position,
             model_.centre_ticks + std::llround(servo_rad / model_.present_position.unit));
  table_.set_value(model_.present_velocity, bridge::turned(c, joint.velocity_rad_s));
  show_current();
  warm();
}

void Servo::show_current() {
  const double torque_nm = torque_is_on() ? motion_.torque_nm : 0;
  const double own_a = bridge::turned(place_.calibration, torque_nm) / model_.torque_constant_nm_a;
  table_.set_value(model_.present_current, own_a + std::copysign(extra_current_a_, own_a));
}

void Servo::warm() {
  if (heat_c_) table_.set_value(model_.present_temperature, *heat_c_);
  const bool too_hot =
      table_.get(model_.present_temperature) > table_.get(model_.temperature_limit);
  const std::int64_t errors = table_.get(model_.hardware_error_status);
  if (!too_hot || (errors & dxl::kOverheatingError) != 0) return;
  table_.set(model_.hardware_error_status, errors | dxl::kOverheatingError);
  note_("hardware_error", name() + " overheating");
  if ((table_.get(servo_items::kShutdown) & dxl::kOverheatingError) != 0) set_torque(false);
}

void Servo::suffer(const Effects& effects) {
  is_silent_ = effects.silent[place_.joint];
  extra_current_a_ = effects.extra_current_a[place_.joint];
  heat_c_ = effects.temperature_c[place_.joint];
  if (!heat_c_) table_.set(model_.present_temperature, kServoTemperatureC);
  show_current();
  warm();
}

}  // namespace scarab::emulator
