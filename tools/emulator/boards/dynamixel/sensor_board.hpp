#pragma once

#include <cstdint>

#include "tools/emulator/boards/dynamixel/control_table.hpp"
#include "tools/emulator/boards/dynamixel/device.hpp"

namespace scarab::emulator {

/// A small board on the bus whose control table holds measurements and nothing that can be written:
/// an IMU, or the feet's forces.
class SensorBoard final : public Device {
 public:
  explicit SensorBoard(std::uint8_t id) : id_(id) {}

  void add(const dxl::Item& item) { table_.add({item}); }
  void show(const dxl::Item& item, double value) { table_.set_value(item, value); }
  void silence(bool silent) { is_silent_ = silent; }

  [[nodiscard]] std::uint8_t id() const override { return id_; }
  [[nodiscard]] bool is_awake(std::int64_t now_ns) const override;
  [[nodiscard]] dxl::PingAnswer ping() const override;
  [[nodiscard]] dxl::Status read(dxl::Region region) const override;
  dxl::StatusError write(std::uint16_t address, dxl::ByteView data) override;
  void reboot(std::int64_t now_ns) override;
  void hear(std::int64_t) override {}
  [[nodiscard]] dxl::Status status(dxl::StatusError error) const override;
  [[nodiscard]] std::int64_t status_return_level() const override;
  [[nodiscard]] std::int64_t return_delay_ns() const override { return 0; }

 private:
  std::uint8_t id_;
  ControlTable table_;
  bool is_silent_ = false;
  std::int64_t awake_from_ns_ = 0;
};

}  // namespace scarab::emulator
