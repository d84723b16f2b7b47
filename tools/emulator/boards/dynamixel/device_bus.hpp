#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"
#include "tools/emulator/boards/board.hpp"
#include "tools/emulator/boards/dynamixel/device.hpp"

namespace scarab::emulator {

/// The devices' end of a bus of DYNAMIXEL Protocol 2.0: ping, read, write, registered write,
/// action, reboot, sync read, fast sync read, sync write. Every other instruction is answered with
/// an instruction error.
///
/// A packet with a wrong CRC is answered with a CRC error by the device it seems to be for. In a
/// sync read each device waits for the one before it in the list, so one that is silent silences
/// those behind it.
class DeviceBus {
 public:
  explicit DeviceBus(Note note) : note_(std::move(note)) {}

  /// `device` outlives the bus.
  void add(Device& device);
  /// A byte has arrived; appends what the devices answer.
  void feed(std::uint8_t byte, std::int64_t now_ns, std::vector<Reply>& replies);

 private:
  using Replies = std::vector<Reply>;

  void obey(const dxl::Packet& packet, std::int64_t now_ns, Replies& replies);
  void obey_one(Device& device, const dxl::Packet& packet, std::int64_t now_ns, Replies& replies);
  void obey_write(Device& device, const dxl::Packet& packet, Replies& replies);
  void obey_all(const dxl::Packet& packet, std::int64_t now_ns, Replies& replies);
  void sync_read(const dxl::Packet& packet, std::int64_t now_ns, Replies& replies);
  void sync_write(const dxl::Packet& packet, std::int64_t now_ns);
  void act(Device& device);
  void complain_of_bad_frame(std::uint8_t id, std::int64_t now_ns, Replies& replies);
  [[nodiscard]] Device* find(std::uint8_t id, std::int64_t now_ns) const;
  [[nodiscard]] std::uint64_t bad_frames() const;

  Note note_;
  dxl::Parser parser_;
  std::vector<Device*> devices_;  // in the order of their IDs
  std::vector<std::pair<Device*, dxl::WriteRequest>> registered_;
};

}  // namespace scarab::emulator
