#pragma once

#include <cstdint>
#include <string>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "services/robot_bridge/drivers/amosii/config.hpp"
#include "services/robot_bridge/drivers/amosii/protocol/parsers.hpp"
#include "tools/emulator/boards/board.hpp"

namespace scarab::emulator {

/// AMOS II's second board: obeys set frames, answers gets with feet, inclinometer and the current
/// of all motors. Servos have power from the first set frame on; the board cannot take it away.
///
/// All other inputs (light, distance) read the middle of their range.
class AmosiiBoard final : public Board {
 public:
  AmosiiBoard(const bridge::amosii::Config& config, const robot::RobotModel& robot,
              const bridge::Calibration& calibration, Note note);

  [[nodiscard]] std::string description() const override;
  [[nodiscard]] unsigned baud() const override { return bridge::amosii::kBaud; }
  void on_byte(std::uint8_t byte, std::int64_t now_ns, std::vector<Reply>& replies) override;
  void tick(std::int64_t) override {}
  [[nodiscard]] std::int64_t next_tick_ns() const override;
  void sense(const plant::Observation& body) override { body_ = body; }
  void suffer(const Effects& effects) override { effects_ = effects; }
  [[nodiscard]] const Drive& drive() const override { return drive_; }
  [[nodiscard]] std::uint64_t power_ups() const override { return sets_; }
  void put_back() override;

 private:
  void obey(const bridge::amosii::Slots& motors);
  [[nodiscard]] bridge::amosii::Slots sensors() const;

  bridge::amosii::Config config_;
  bridge::Calibration calibration_;
  Note note_;
  bridge::amosii::CommandParser parser_;
  std::uint64_t bad_frames_ = 0;
  bridge::amosii::Slots motors_{};
  std::uint64_t sets_ = 0;
  Drive drive_;
  plant::Observation body_;
  Effects effects_;
};

}  // namespace scarab::emulator
