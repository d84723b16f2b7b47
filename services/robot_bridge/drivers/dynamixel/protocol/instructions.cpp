#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"

#include <stdexcept>

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::size_t kAddressBytes = 2;
constexpr std::size_t kRegionBytes = 4;
constexpr std::size_t kPingBytes = 3;

Packet make(std::uint8_t id, Instruction instruction, Bytes parameters = {}) {
  return {id, static_cast<std::uint8_t>(instruction), std::move(parameters)};
}

Bytes bytes_of(Region region) {
  Bytes bytes;
  append_little(bytes, region.address, 2);
  append_little(bytes, region.size, 2);
  return bytes;
}

Packet write_with(Instruction instruction, std::uint8_t id, std::uint16_t address, ByteView data) {
  Bytes parameters;
  append_little(parameters, address, kAddressBytes);
  parameters.insert(parameters.end(), data.begin(), data.end());
  return make(id, instruction, std::move(parameters));
}

Packet sync_read_with(Instruction instruction, Region region,
                      const std::vector<std::uint8_t>& ids) {
  Bytes parameters = bytes_of(region);
  parameters.insert(parameters.end(), ids.begin(), ids.end());
  return make(kBroadcastId, instruction, std::move(parameters));
}

/// The region in the first parameters, which are there.
Region region_of(ByteView parameters) {
  return {static_cast<std::uint16_t>(read_little(parameters.slice(0, 2))),
          static_cast<std::uint16_t>(read_little(parameters.slice(2, 2)))};
}

}  // namespace

Packet ping(std::uint8_t id) { return make(id, Instruction::kPing); }

Packet read(std::uint8_t id, Region region) {
  return make(id, Instruction::kRead, bytes_of(region));
}

Packet write(std::uint8_t id, std::uint16_t address, ByteView data) {
  return write_with(Instruction::kWrite, id, address, data);
}

Packet reg_write(std::uint8_t id, std::uint16_t address, ByteView data) {
  return write_with(Instruction::kRegWrite, id, address, data);
}

Packet action(std::uint8_t id) { return make(id, Instruction::kAction); }

Packet reboot(std::uint8_t id) { return make(id, Instruction::kReboot); }

Packet sync_read(Region region, const std::vector<std::uint8_t>& ids) {
  return sync_read_with(Instruction::kSyncRead, region, ids);
}

Packet fast_sync_read(Region region, const std::vector<std::uint8_t>& ids) {
  return sync_read_with(Instruction::kFastSyncRead, region, ids);
}

Packet sync_write(const SyncWriteRequest& request) {
  Bytes parameters = bytes_of(request.region);
  for (const SyncWriteItem& item : request.items) {
    if (item.data.size() != request.region.size) {
      throw std::invalid_argument("a sync write's item is not as long as its region");
    }
    parameters.push_back(item.id);
    parameters.insert(parameters.end(), item.data.begin(), item.data.end());
  }
  return make(kBroadcastId, Instruction::kSyncWrite, std::move(parameters));
}

std::optional<Region> as_read(const Packet& packet) {
  if (!packet.is(Instruction::kRead) || packet.parameters.size() != kRegionBytes) {
    return std::nullopt;
  }
  return region_of(packet.parameters);
}

std::optional<WriteRequest> as_write(const Packet& packet) {
  const bool write = packet.is(Instruction::kWrite) || packet.is(Instruction::kRegWrite);
  if (!write || packet.parameters.size() <= kAddressBytes) return std::nullopt;
  const ByteView parameters = packet.parameters;
  return WriteRequest{static_cast<std::uint16_t>(read_little(parameters.slice(0, kAddressBytes))),
                      parameters.from(kAddressBytes).copy()};
}

std::optional<SyncReadRequest> as_sync_read(const Packet& packet) {
  const bool sync = packet.is(Instruction::kSyncRead) || packet.is(Instruction::kFastSyncRead);
  if (!sync || packet.parameters.size() <= kRegionBytes) return std::nullopt;
  const ByteView parameters = packet.parameters;
  return SyncReadRequest{region_of(parameters), parameters.from(kRegionBytes).copy()};
}

std::optional<SyncWriteRequest> as_sync_write(const Packet& packet) {
  if (!packet.is(Instruction::kSyncWrite) || packet.parameters.size() <= kRegionBytes) {
    return std::nullopt;
  }
  const ByteView parameters = packet.parameters;
  SyncWriteRequest request{region_of(parameters), {}};
  const ByteView items = parameters.from(kRegionBytes);
  const std::size_t each = 1U + request.region.size;
  if (request.region.size == 0 || items.size() % each != 0) return std::nullopt;
  for (std::size_t at = 0; at < items.size(); at += each) {
    request.items.push_back({items[at], items.slice(at + 1, request.region.size).copy()});
  }
  return request;
}

Bytes to_data(const PingAnswer& answer) {
  Bytes data;
  append_little(data, answer.model_number, 2);
  data.push_back(answer.firmware);
  return data;
}

std::optional<PingAnswer> as_ping_answer(ByteView data) {
  if (data.size() != kPingBytes) return std::nullopt;
  return PingAnswer{static_cast<std::uint16_t>(read_little(data.slice(0, 2))), data[2]};
}

}  // namespace scarab::bridge::dynamixel
