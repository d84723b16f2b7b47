#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"

/// What a controller tells its devices (e-Manual, Protocol 2.0, "Instruction Details"), and how a
/// device reads it. Readers give none if the packet is another instruction or its parameters do not
/// make sense.
namespace scarab::bridge::dynamixel {

/// Bytes of a control table.
struct Region {
  std::uint16_t address = 0;
  std::uint16_t size = 0;
};

inline bool operator==(const Region& a, const Region& b) {
  return a.address == b.address && a.size == b.size;
}

struct WriteRequest {
  std::uint16_t address = 0;
  Bytes data;
};

/// The same region of several devices.
struct SyncReadRequest {
  Region region;
  std::vector<std::uint8_t> ids;
};

struct SyncWriteItem {
  std::uint8_t id = 0;
  Bytes data;
};

/// Every item has as many bytes as `region`.
struct SyncWriteRequest {
  Region region;
  std::vector<SyncWriteItem> items;
};

/// What a ping is answered with.
struct PingAnswer {
  std::uint16_t model_number = 0;
  std::uint8_t firmware = 0;
};

[[nodiscard]] Packet ping(std::uint8_t id);
[[nodiscard]] Packet read(std::uint8_t id, Region region);
[[nodiscard]] Packet write(std::uint8_t id, std::uint16_t address, ByteView data);
/// Held back until action().
[[nodiscard]] Packet reg_write(std::uint8_t id, std::uint16_t address, ByteView data);
[[nodiscard]] Packet action(std::uint8_t id);
[[nodiscard]] Packet reboot(std::uint8_t id);
/// Answered with a status from each, in the order of `ids`.
[[nodiscard]] Packet sync_read(Region region, const std::vector<std::uint8_t>& ids);
/// Answered with one status for all (fast_status.hpp).
[[nodiscard]] Packet fast_sync_read(Region region, const std::vector<std::uint8_t>& ids);
/// Not answered. Throws std::invalid_argument if an item is not as long as the region.
[[nodiscard]] Packet sync_write(const SyncWriteRequest& request);

[[nodiscard]] std::optional<Region> as_read(const Packet& packet);
/// Of a write or a registered write.
[[nodiscard]] std::optional<WriteRequest> as_write(const Packet& packet);
/// Of a sync read or a fast sync read.
[[nodiscard]] std::optional<SyncReadRequest> as_sync_read(const Packet& packet);
[[nodiscard]] std::optional<SyncWriteRequest> as_sync_write(const Packet& packet);

[[nodiscard]] Bytes to_data(const PingAnswer& answer);
/// From the data of a status.
[[nodiscard]] std::optional<PingAnswer> as_ping_answer(ByteView data);

}  // namespace scarab::bridge::dynamixel
