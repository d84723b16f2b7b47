#include "services/robot_bridge/drivers/dynamixel/protocol/fast_status.hpp"

#include <stdexcept>

#include "services/robot_bridge/drivers/dynamixel/protocol/crc16.hpp"

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::size_t kErrorAndId = 2;
constexpr std::size_t kInstructionBytes = 1;

Status part(ByteView bytes, std::size_t data_bytes) {
  Status status = status_of(bytes[1], bytes[0]);
  status.data = bytes.slice(kErrorAndId, data_bytes).copy();
  return status;
}

}  // namespace

std::size_t fast_status_bytes(std::size_t devices, std::size_t data_bytes) {
  return kPrefixBytes + kInstructionBytes + devices * (kErrorAndId + data_bytes + kCrcBytes);
}

std::vector<Bytes> encode_fast_status(const std::vector<Status>& statuses) {
  if (statuses.empty()) return {};
  const std::size_t data_bytes = statuses.front().data.size();
  const std::size_t length = fast_status_bytes(statuses.size(), data_bytes) - kPrefixBytes;
  if (length > kMaxLength) throw std::invalid_argument("too many devices for one fast status");

  std::vector<Bytes> chunks;
  Bytes chunk{0xFF, 0xFF, 0xFD, 0x00, kBroadcastId};
  append_little(chunk, static_cast<std::uint32_t>(length), 2);
  chunk.push_back(static_cast<std::uint8_t>(Instruction::kStatus));
  std::uint16_t crc = 0;
  for (const Status& status : statuses) {
    if (status.data.size() != data_bytes) {
      throw std::invalid_argument("data of different lengths in one fast status");
    }
    chunk.push_back(error_byte(status));
    chunk.push_back(status.id);
    chunk.insert(chunk.end(), status.data.begin(), status.data.end());
    crc = crc16(chunk, crc);
    const std::size_t before = chunk.size();
    append_little(chunk, crc, kCrcBytes);
    crc = crc16(ByteView(chunk).from(before), crc);
    chunks.push_back(std::move(chunk));
    chunk.clear();
  }
  return chunks;
}

std::optional<std::vector<Status>> as_fast_status(const Packet& packet, std::size_t data_bytes) {
  const std::size_t each = kErrorAndId + data_bytes + kCrcBytes;
  // The last device's CRC is the packet's own, and no longer with the parameters.
  const std::size_t size = packet.parameters.size() + kCrcBytes;
  if (!is_never_stuffed(packet.id, packet.instruction) || size % each != 0) return std::nullopt;
  std::vector<Status> statuses;
  for (std::size_t at = 0; at < packet.parameters.size(); at += each) {
    statuses.push_back(part(ByteView(packet.parameters).from(at), data_bytes));
  }
  return statuses;
}

std::vector<Status> answered_so_far(ByteView begun, std::size_t data_bytes) {
  constexpr std::size_t kBefore = kPrefixBytes + kInstructionBytes;
  std::vector<Status> statuses;
  if (begun.size() < kBefore || !is_never_stuffed(begun[4], begun[kPrefixBytes])) return statuses;
  const std::size_t each = kErrorAndId + data_bytes + kCrcBytes;
  for (std::size_t at = kBefore; at + each <= begun.size(); at += each) {
    const std::size_t checked = at + each - kCrcBytes;
    const std::uint32_t told = read_little(begun.slice(checked, kCrcBytes));
    if (crc16(begun.slice(0, checked)) != told) break;
    statuses.push_back(part(begun.from(at), data_bytes));
  }
  return statuses;
}

}  // namespace scarab::bridge::dynamixel
