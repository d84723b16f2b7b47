#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"
#include "tests/unit/robot_bridge/serial/pseudo_terminal.hpp"

namespace scarab::bridge::dynamixel {

/// A device of the tests: bytes at addresses, as the manual has them. Little of a servo's mind:
/// goals outside of the position limits or behind a tripped watchdog are refused, and torque with a
/// hardware error.
struct ScriptedDevice {
  std::uint16_t model_number = 1020;
  std::uint8_t firmware = 45;
  std::array<std::uint8_t, 256> memory{};
  bool silent = false;
  int lost_writes = 0;  ///< so many more do not arrive

  /// An XM430-W350 as it comes from the factory, standing at `ticks`.
  static ScriptedDevice servo(int ticks = 2048);

  [[nodiscard]] std::int32_t get(std::size_t address, std::size_t size) const;
  void set(std::size_t address, std::size_t size, std::int64_t value);
};

/// Devices on a line, played by a thread of the test: answers as DYNAMIXEL Protocol 2.0 says, or as
/// the test's script changes it.
class ScriptedBus {
 public:
  /// Changes the bytes of an answer, or takes them away.
  using Script = std::function<Bytes(const Packet& instruction, Bytes answer)>;

  explicit ScriptedBus(std::map<std::uint8_t, ScriptedDevice> devices);
  ~ScriptedBus();
  ScriptedBus(const ScriptedBus&) = delete;
  ScriptedBus& operator=(const ScriptedBus&) = delete;

  [[nodiscard]] std::string path() const { return line_.path(); }

  void script(Script script);
  /// Changes a device between two instructions.
  void change(std::uint8_t id, const std::function<void(ScriptedDevice&)>& change);
  [[nodiscard]] ScriptedDevice device(std::uint8_t id);
  /// All instructions so far.
  [[nodiscard]] std::vector<Packet> heard();
  void forget_heard();
  void unplug();

 private:
  void run();
  void answer(const Packet& instruction);
  [[nodiscard]] Bytes reply(const Packet& instruction);
  [[nodiscard]] Bytes reply_to_one(ScriptedDevice& device, const Packet& instruction);
  [[nodiscard]] Bytes reply_of_all(const Packet& instruction);

  test::PseudoTerminal line_;
  std::map<std::uint8_t, ScriptedDevice> devices_;
  Script script_;
  std::vector<Packet> heard_;
  std::mutex mutex_;
  std::condition_variable ending_;
  bool end_ = false;
  bool unplug_ = false;
  std::thread thread_;
};

}  // namespace scarab::bridge::dynamixel
