#include "tests/unit/emulator/dynamixel_rig.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <tuple>

#include "common/config/robot_file.hpp"
#include "services/robot_bridge/calibration_file.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"

namespace scarab::emulator::testing {
namespace {

std::filesystem::path source_file(const char* relative) {
  return std::filesystem::path(SCARAB_SOURCE_DIR) / relative;
}

}  // namespace

Bytes hex(const std::string& text) {
  std::istringstream words(text);
  Bytes bytes;
  for (std::string word; words >> word;) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(word, nullptr, 16)));
  }
  return bytes;
}

DynamixelRig::DynamixelRig() {
  const auto robot = config::load_robot(source_file("config/robot/beetle.yaml"));
  const auto bridge = bridge::load_config(source_file("config/robot_bridge/beetle-dynamixel.yaml"));
  config = *std::get<std::optional<dxl::Config>>(bridge.sections);
  // The one whose control table is published, whatever the shipped robot has.
  for (auto& [joint, servo] : config.servos) servo.model = dxl::kBuiltInModel;
  calibration = bridge::load_calibration(bridge.calibration, robot);
  board = std::make_unique<DynamixelBoard>(
      config, robot, calibration, [this](std::string_view event, const std::string& detail) {
        notes.emplace_back(event, detail);
      });
  board->sense(body);
}

Bytes DynamixelRig::say(const Bytes& bytes, std::int64_t now_ns) {
  replies.clear();
  for (const std::uint8_t byte : bytes) board->on_byte(byte, now_ns, replies);
  Bytes all;
  for (const Reply& reply : replies) all.insert(all.end(), reply.bytes.begin(), reply.bytes.end());
  return all;
}

dxl::Status DynamixelRig::ask(const dxl::Packet& packet, std::int64_t now_ns) {
  dxl::Parser parser;
  std::vector<dxl::Packet> packets;
  parser.feed(say(packet, now_ns), packets);
  EXPECT_EQ(packets.size(), 1U);
  if (packets.size() != 1) return {};
  const auto status = dxl::as_status(packets.front());
  EXPECT_TRUE(status);
  return status.value_or(dxl::Status{});
}

dxl::StatusError DynamixelRig::write(std::uint8_t id, const dxl::Item& item, std::int64_t count,
                                     std::int64_t now_ns) {
  return ask(dxl::write(id, item.address, dxl::bytes_of(item, count)), now_ns).error;
}

std::int64_t DynamixelRig::read(std::uint8_t id, const dxl::Item& item, std::int64_t now_ns) {
  const dxl::Status status = ask(dxl::read(id, item.region()), now_ns);
  EXPECT_EQ(status.error, dxl::StatusError::kNone);
  return status.data.size() == item.size() ? dxl::count_in(item, status.data) : -1;
}

double DynamixelRig::joint_rad(std::uint8_t id, int ticks) const {
  const double servo_rad = (ticks - model.centre_ticks) * model.goal_position.unit;
  return bridge::to_joint_rad(*calibration.joints.at(id - 1U), servo_rad);
}

void DynamixelRig::stand_at(const std::vector<std::pair<std::uint8_t, int>>& ticks) {
  for (const auto& [id, at] : ticks) body.position_rad.at(id - 1U) = joint_rad(id, at);
  board->sense(body);
}

std::vector<std::string> DynamixelRig::noted(const std::string& event) const {
  std::vector<std::string> details;
  for (const auto& [name, detail] : notes) {
    if (name == event) details.push_back(detail);
  }
  return details;
}

}  // namespace scarab::emulator::testing
