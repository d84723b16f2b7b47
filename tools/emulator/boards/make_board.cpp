#include "tools/emulator/boards/make_board.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "tools/emulator/boards/amosii/board.hpp"
#include "tools/emulator/boards/dynamixel/board.hpp"

namespace scarab::emulator {
namespace {

template <class Section>
const Section& section_of(const bridge::BridgeConfig& config) {
  return *std::get<std::optional<Section>>(config.sections);
}

}  // namespace

std::unique_ptr<Board> make_board(const bridge::BridgeConfig& config,
                                  const robot::RobotModel& robot,
                                  const bridge::Calibration& calibration, Note note) {
  const std::string driver(bridge::kDriverNames.at(bridge::index_of(config.driver)));
  if (driver == "amosii") {
    return std::make_unique<AmosiiBoard>(section_of<bridge::amosii::Config>(config), robot,
                                         calibration, std::move(note));
  }
  if (driver == "dynamixel") {
    return std::make_unique<DynamixelBoard>(section_of<dxl::Config>(config), robot, calibration,
                                            std::move(note));
  }
  throw std::invalid_argument("there is no board to emulate for the driver " + driver +
                              ": amosii and dynamixel have one");
}

}  // namespace scarab::emulator
