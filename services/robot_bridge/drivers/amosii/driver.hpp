#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/driver.hpp"
#include "services/robot_bridge/drivers/amosii/board.hpp"
#include "services/robot_bridge/drivers/amosii/config.hpp"

namespace scarab::bridge::amosii {

/// AMOS II behind the bridge's interface.
///
/// Its servos tell nothing: positions are those commanded, none before the first command. The board
/// has no switch for their torque and no time-out: powered, the servos hold what they were last
/// told. So the first command after power-on moves every joint at its servo's full speed to where
/// activate() says it stands; hold() has nothing to send; release() cannot be done and says so.
class AmosiiDriver : public Driver {
 public:
  AmosiiDriver(Config config, const robot::RobotModel& robot, const Calibration& calibration);

  void open() override;
  void close() noexcept override;
  Readings read() override;
  void activate(const robot::JointVector& hold_rad) override;
  void write(const robot::JointVector& target_rad) override;
  bool hold() noexcept override;
  bool release() noexcept override;
  [[nodiscard]] Capabilities capabilities() const override;
  [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> counters() const override;

 private:
  [[nodiscard]] Board& board();

  Config config_;
  Calibration calibration_;  ///< of the robot's own joints
  BoardCounters counters_;
  std::optional<Board> board_;
  std::optional<robot::JointVector> commanded_rad_;  ///< as far as the servos reach
};

}  // namespace scarab::bridge::amosii
