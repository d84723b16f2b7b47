#include "services/robot_bridge/drivers/dynamixel/boards.hpp"

namespace scarab::bridge::dynamixel {
namespace {

/// The answer to a read of a board's region, taken apart.
class BoardAnswer {
 public:
  BoardAnswer(Bus& bus, std::uint8_t id, Region region)
      : region_(region), data_(bus.ask(read(id, region), region.size).data) {}

  [[nodiscard]] double value(const Item& item) const {
    const auto offset = static_cast<std::size_t>(item.address - region_.address);
    return value_in(item, ByteView(data_).slice(offset, item.size()));
  }

 private:
  Region region_;
  Bytes data_;
};

}  // namespace

std::vector<std::uint8_t> boards_of(const Config& config) {
  std::vector<std::uint8_t> ids;
  if (config.imu) ids.push_back(config.imu->id);
  if (config.foot_force) ids.push_back(config.foot_force->id);
  return ids;
}

Region region_of(const ImuConfig& board) {
  Region region = hull(board.roll.region(), board.pitch.region());
  for (const Item& item : board.angular_velocity) region = hull(region, item.region());
  for (const Item& item : board.acceleration) region = hull(region, item.region());
  return region;
}

Region region_of(const FootForceConfig& board) {
  Region region = board.force.front().region();
  for (const Item& item : board.force) region = hull(region, item.region());
  return region;
}

void read_board(Bus& bus, const ImuConfig& board, Readings& readings) {
  const BoardAnswer answer(bus, board.id, region_of(board));
  readings.roll_rad = answer.value(board.roll);
  readings.pitch_rad = answer.value(board.pitch);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    readings.angular_velocity_rad_s[axis] = answer.value(board.angular_velocity[axis]);
    readings.acceleration_m_s2[axis] = answer.value(board.acceleration[axis]);
  }
  readings.imu_source = Source::kMeasured;
  readings.motion_source = Source::kMeasured;
}

void read_board(Bus& bus, const FootForceConfig& board, Readings& readings) {
  const BoardAnswer answer(bus, board.id, region_of(board));
  for (std::size_t leg = 0; leg < robot::kLegCount; ++leg) {
    readings.foot_force_n[leg] = answer.value(board.force[leg]);
    readings.foot_force_source[leg] = Source::kMeasured;
  }
}

}  // namespace scarab::bridge::dynamixel
