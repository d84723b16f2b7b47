#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/emulator/boards/dynamixel/board.hpp"

namespace scarab::emulator::testing {

using Bytes = std::vector<std::uint8_t>;

/// "FF 01" as bytes.
[[nodiscard]] Bytes hex(const std::string& text);

/// The shipped beetle's bus, spoken to in bytes: IDs are joint slots + 1.
class DynamixelRig {
 public:
  DynamixelRig();

  /// All that is answered, one after the other.
  Bytes say(const Bytes& bytes, std::int64_t now_ns = 0);
  Bytes say(const std::string& text) { return say(hex(text)); }
  Bytes say(const dxl::Packet& packet, std::int64_t now_ns = 0) {
    return say(dxl::encode(packet), now_ns);
  }
  /// The one status that answers; its error must be what the caller expects of it.
  dxl::Status ask(const dxl::Packet& packet, std::int64_t now_ns = 0);
  dxl::StatusError write(std::uint8_t id, const dxl::Item& item, std::int64_t count,
                         std::int64_t now_ns = 0);
  std::int64_t read(std::uint8_t id, const dxl::Item& item, std::int64_t now_ns = 0);

  /// The servos of these IDs stand at these ticks of their scale.
  void stand_at(const std::vector<std::pair<std::uint8_t, int>>& ticks);
  [[nodiscard]] double joint_rad(std::uint8_t id, int ticks) const;
  /// Events with this name so far.
  [[nodiscard]] std::vector<std::string> noted(const std::string& event) const;

  std::vector<std::pair<std::string, std::string>> notes;
  std::vector<Reply> replies;  ///< of the last say()
  bridge::Calibration calibration;
  dxl::ServoModel model;
  dxl::Config config;
  plant::Observation body;
  std::unique_ptr<DynamixelBoard> board;
};

}  // namespace scarab::emulator::testing
