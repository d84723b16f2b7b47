#include "tools/emulator/boards/dynamixel/sensor_board.hpp"

#include <utility>

namespace scarab::emulator {
namespace {

/// No servo's: boards of one's own have no number at ROBOTIS.
constexpr dxl::PingAnswer kModel{0xFFF0, 1};
constexpr std::int64_t kRebootNs = 100'000'000;

}  // namespace

bool SensorBoard::is_awake(std::int64_t now_ns) const {
  return !is_silent_ && now_ns >= awake_from_ns_;
}

dxl::PingAnswer SensorBoard::ping() const { return kModel; }

dxl::Status SensorBoard::status(dxl::StatusError error) const { return {id_, false, error, {}}; }

dxl::Status SensorBoard::read(dxl::Region region) const {
  auto data = table_.read(region);
  dxl::Status answer = status(data ? dxl::StatusError::kNone : dxl::StatusError::kAccess);
  if (data) answer.data = std::move(*data);
  return answer;
}

dxl::StatusError SensorBoard::write(std::uint16_t address, dxl::ByteView data) {
  return table_.check(address, data, false);
}

void SensorBoard::reboot(std::int64_t now_ns) { awake_from_ns_ = now_ns + kRebootNs; }

std::int64_t SensorBoard::status_return_level() const { return dxl::kReturnAllStatuses; }

}  // namespace scarab::emulator
