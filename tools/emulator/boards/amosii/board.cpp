#include "tools/emulator/boards/amosii/board.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>
#include <variant>

#include "services/robot_bridge/drivers/amosii/protocol/frames.hpp"
#include "services/robot_bridge/drivers/amosii/protocol/slots.hpp"
#include "services/robot_bridge/drivers/amosii/protocol/values.hpp"

namespace scarab::emulator {

namespace amos = bridge::amosii;

namespace {

/// The joints that the robot has and the board knows where to find.
bridge::Calibration of_present(bridge::Calibration calibration, const robot::RobotModel& robot) {
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    if (!robot.joints[j].present) calibration.joints[j].reset();
  }
  return calibration;
}

std::uint8_t angle_byte(const amos::InclinationAxis& axis, double angle_rad) {
  return amos::input_byte({axis.zero_byte, axis.rad_per_byte}, angle_rad);
}

}  // namespace

AmosiiBoard::AmosiiBoard(const amos::Config& config, const robot::RobotModel& robot,
                         const bridge::Calibration& calibration, Note note)
    : config_(config), calibration_(of_present(calibration, robot)), note_(std::move(note)) {}

std::string AmosiiBoard::description() const { return "AMOS II's second board"; }

std::int64_t AmosiiBoard::next_tick_ns() const { return std::numeric_limits<std::int64_t>::max(); }

void AmosiiBoard::put_back() {
  drive_.powered.reset();
  motors_ = {};
}

void AmosiiBoard::on_byte(std::uint8_t byte, std::int64_t /*now_ns*/, std::vector<Reply>& replies) {
  const auto command = parser_.push(byte);
  if (parser_.implausible_sets() != bad_frames_) {
    bad_frames_ = parser_.implausible_sets();
    note_("frame_bad", "a set frame with values that cannot be");
  }
  if (!command) return;
  if (const auto* motors = std::get_if<amos::Slots>(&*command)) {
    obey(*motors);
    return;
  }
  const amos::ReplyFrame frame = amos::encode_reply(sensors());
  replies.push_back({{frame.begin(), frame.end()}});
}

void AmosiiBoard::obey(const amos::Slots& motors) {
  ++sets_;
  if (drive_.powered.none()) note_("torque_on", "all by the first set frame");
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    const auto& calibration = calibration_.joints[j];
    if (!calibration || effects_.silent[j]) continue;
    const std::size_t slot = amos::kMotorSlots[j].slot;
    drive_.powered.set(j);
    if (motors_[slot] == motors[slot]) continue;
    motors_[slot] = motors[slot];
    drive_.target_rad[j] =
        amos::joint_angle_for(*calibration, amos::motor_command(j, motors[slot]));
    note_("goal", fmt::format("{} {:.4f}", robot::kJointNames[j], drive_.target_rad[j]));
  }
}

amos::Slots AmosiiBoard::sensors() const {
  amos::Slots slots = amos::all_slots(amos::kMiddle);
  for (std::size_t leg = 0; leg < robot::kLegCount; ++leg) {
    slots[amos::kFootSlots[leg].slot] =
        amos::foot_byte(leg, body_.foot_force_n[leg] / config_.foot_full_scale_n);
  }
  if (config_.inclinometer && !effects_.imu_silent) {
    slots[amos::kInclinometerXSlot] = angle_byte(config_.inclinometer->roll, body_.roll_rad);
    slots[amos::kInclinometerYSlot] =
        angle_byte(config_.inclinometer->pitch, body_.pitch_rad + effects_.tilt_rad);
  }
  double current_a = drive_.powered.any() ? body_.supply_current_a : 0;
  for (const double extra_a : effects_.extra_current_a) current_a += extra_a;
  slots[amos::kMotorCurrentSlot] = amos::input_byte(
      {config_.motor_current.zero_byte, config_.motor_current.a_per_byte}, current_a);
  return slots;
}

}  // namespace scarab::emulator
