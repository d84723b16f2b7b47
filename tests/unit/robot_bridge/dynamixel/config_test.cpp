#include "services/robot_bridge/drivers/dynamixel/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/config/config.hpp"

namespace scarab::bridge::dynamixel {
namespace {

using ::testing::HasSubstr;

const std::string kBus = R"(port: /dev/ttyUSB0
baud: 1000000
sync_read: fast
reply_timeout_s: 0.005
retries: 2
bus_watchdog_s: 0.2
)";

std::string error_of(const std::string& text) {
  try {
    static_cast<void>(config::load_text<Config>("bus.yaml", text));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(DynamixelConfig, BuiltInServosNeedNoMoreThanAnId) {
  const auto c =
      config::load_text<Config>("bus.yaml", kBus + "servos: {TL0: {id: 1}, BJ: {id: 19}}\n");
  EXPECT_EQ(c.servos.at("BJ").id, 19);
  EXPECT_EQ(c.servos.at("BJ").model, "xm430-w350");
  EXPECT_EQ(find_model(c, "xm430-w350")->model_number, 1020);
  EXPECT_EQ(c.sync_read, SyncReadKind::kFast);
  EXPECT_FALSE(c.imu);
}

TEST(DynamixelConfig, OtherServosAndBoards) {
  const std::string text = kBus + R"(servos: {TL0: {id: 1, model: xl430-w250}}
models:
  xl430-w250:
    model_number: 1060
    torque_constant_nm_a: 1.1
    present_current: {address: 126, type: i16, unit: 0.001}
imu:
  id: 100
  roll: {address: 20, type: i16, unit: 0.001}
  pitch: {address: 22, type: i16, unit: 0.001}
  angular_velocity:
    - {address: 24, type: f32, unit: 1}
    - {address: 28, type: f32, unit: 1}
    - {address: 32, type: f32, unit: 1}
  acceleration:
    - {address: 36, type: i16, unit: 0.01}
    - {address: 38, type: i16, unit: 0.01}
    - {address: 40, type: i16, unit: 0.01}
)";
  const auto c = config::load_text<Config>("bus.yaml", text);
  const auto model = find_model(c, "xl430-w250");
  ASSERT_TRUE(model);
  EXPECT_EQ(model->model_number, 1060);
  EXPECT_EQ(model->present_current.unit, 0.001);
  EXPECT_EQ(model->goal_position.address, 116);  // as the built-in one has it
  ASSERT_TRUE(c.imu);
  EXPECT_EQ(c.imu->angular_velocity[2].type, Type::kF32);
  const std::string dumped = config::dump(c);
  EXPECT_EQ(config::dump(config::load_text<Config>("dump.yaml", dumped)), dumped);
}

TEST(DynamixelConfig, MistakesAreNamed) {
  EXPECT_THAT(error_of(kBus + "servos: {TX0: {id: 1}}\n"), HasSubstr("servos.TX0: is no joint"));
  EXPECT_THAT(error_of(kBus + "servos: {TL0: {id: 1}, TL1: {id: 1}}\n"),
              HasSubstr("servos.TL1.id: is the ID of another device"));
  EXPECT_THAT(error_of(kBus + "servos: {TL0: {id: 253}}\n"), HasSubstr("id"));
  EXPECT_THAT(error_of(kBus + "servos: {TL0: {id: 1, model: mx28}}\n"),
              HasSubstr("servos.TL0.model: no such model"));
  EXPECT_THAT(error_of(kBus + "servos: {}\n"), HasSubstr("at least one joint"));
  EXPECT_THAT(error_of(kBus + R"(servos: {TL0: {id: 1}, TL1: {id: 2, model: other}}
models: {other: {model_number: 7, torque_constant_nm_a: 1, goal_position: {address: 596, type: i32, unit: 0.001}}}
)"),
              HasSubstr("TL1.model: has its values at other addresses"));
  EXPECT_THAT(error_of(kBus + R"(servos: {TL0: {id: 1}}
foot_force: {id: 2, force: [{address: 1, type: u8, unit: 0}, {address: 2, type: u8, unit: 1},
  {address: 3, type: u8, unit: 1}, {address: 4, type: u8, unit: 1}, {address: 5, type: u8, unit: 1},
  {address: 6, type: u8, unit: 1}]}
)"),
              HasSubstr("unit: must not be 0"));
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
