#include "tools/emulator/boards/dynamixel/device_bus.hpp"

#include <algorithm>
#include <utility>

#include "services/robot_bridge/drivers/dynamixel/protocol/fast_status.hpp"

namespace scarab::emulator {
namespace {

using dxl::Instruction;
using dxl::StatusError;

/// More than any table has, and few enough for one status.
constexpr std::uint16_t kMostRead = 512;
constexpr std::size_t kIdAt = 4;  // in a frame
constexpr std::int64_t kReturnsReads = 1;
constexpr std::int64_t kReturnsAll = 2;

void answer(const Device& device, const dxl::Status& status, std::vector<Reply>& replies) {
  replies.push_back({dxl::encode(dxl::to_packet(status)), device.return_delay_ns()});
}

/// Where the device answers instructions that are no ping and no read.
void answer_if_told(const Device& device, StatusError error, std::vector<Reply>& replies) {
  if (device.status_return_level() >= kReturnsAll) answer(device, device.status(error), replies);
}

dxl::Status ping_status(const Device& device) {
  dxl::Status status = device.status(StatusError::kNone);
  status.data = dxl::to_data(device.ping());
  return status;
}

dxl::Status read_status(const Device& device, dxl::Region region) {
  return region.size <= kMostRead ? device.read(region) : device.status(StatusError::kDataLength);
}

/// The one status of a fast sync read. The first device announces the length of all, those included
/// that will not follow.
void answer_together(const dxl::SyncReadRequest& request, const std::vector<const Device*>& awake,
                     std::vector<Reply>& replies) {
  if (awake.empty()) return;
  std::vector<dxl::Status> statuses;
  for (std::size_t i = 0; i < request.ids.size(); ++i) {
    statuses.push_back(i < awake.size() ? read_status(*awake[i], request.region)
                                        : dxl::status_of(request.ids[i], 0));
    statuses.back().data.resize(request.region.size);
  }
  const auto chunks = dxl::encode_fast_status(statuses);
  Reply reply{{}, awake.front()->return_delay_ns()};
  for (std::size_t i = 0; i < awake.size(); ++i) {
    reply.bytes.insert(reply.bytes.end(), chunks[i].begin(), chunks[i].end());
  }
  replies.push_back(std::move(reply));
}

}  // namespace

void DeviceBus::add(Device& device) {
  const auto place = std::find_if(devices_.begin(), devices_.end(),
                                  [&](const Device* there) { return there->id() > device.id(); });
  devices_.insert(place, &device);
}

std::uint64_t DeviceBus::bad_frames() const {
  const dxl::ParserCounters& seen = parser_.counters();
  return seen.crc_errors + seen.length_errors + seen.stuffing_errors + seen.cut_short;
}

Device* DeviceBus::find(std::uint8_t id, std::int64_t now_ns) const {
  const auto found = std::find_if(devices_.begin(), devices_.end(),
                                  [id](const Device* device) { return device->id() == id; });
  return found != devices_.end() && (*found)->is_awake(now_ns) ? *found : nullptr;
}

void DeviceBus::feed(std::uint8_t byte, std::int64_t now_ns, Replies& replies) {
  const std::uint64_t bad_before = bad_frames();
  const std::uint64_t wrong_before = parser_.counters().crc_errors;
  const dxl::ByteView begun = parser_.pending();
  const std::uint8_t id = begun.size() > kIdAt ? begun[kIdAt] : dxl::kBroadcastId;
  std::vector<dxl::Packet> packets;
  parser_.feed({&byte, 1}, packets);
  if (bad_frames() != bad_before) note_("frame_bad", "to ID " + std::to_string(id));
  if (parser_.counters().crc_errors != wrong_before) complain_of_bad_frame(id, now_ns, replies);
  for (const dxl::Packet& packet : packets) obey(packet, now_ns, replies);
}

void DeviceBus::complain_of_bad_frame(std::uint8_t id, std::int64_t now_ns, Replies& replies) {
  const Device* device = find(id, now_ns);
  if (device != nullptr) answer_if_told(*device, StatusError::kCrc, replies);
}

void DeviceBus::obey(const dxl::Packet& packet, std::int64_t now_ns, Replies& replies) {
  if (packet.is_status()) return;
  for (Device* device : devices_) {
    if (device->is_awake(now_ns)) device->hear(now_ns);
  }
  if (packet.is(Instruction::kSyncRead) || packet.is(Instruction::kFastSyncRead)) {
    sync_read(packet, now_ns, replies);
  } else if (packet.is(Instruction::kSyncWrite)) {
    sync_write(packet, now_ns);
  } else if (packet.id == dxl::kBroadcastId) {
    obey_all(packet, now_ns, replies);
  } else if (Device* device = find(packet.id, now_ns); device != nullptr) {
    obey_one(*device, packet, now_ns, replies);
  }
}

void DeviceBus::obey_one(Device& device, const dxl::Packet& packet, std::int64_t now_ns,
                         Replies& replies) {
  if (packet.is(Instruction::kPing)) {
    answer(device, ping_status(device), replies);
  } else if (packet.is(Instruction::kRead)) {
    if (device.status_return_level() < kReturnsReads) return;
    const auto region = dxl::as_read(packet);
    answer(device, region ? read_status(device, *region) : device.status(StatusError::kDataLength),
           replies);
  } else if (packet.is(Instruction::kWrite) || packet.is(Instruction::kRegWrite)) {
    obey_write(device, packet, replies);
  } else if (packet.is(Instruction::kAction)) {
    act(device);
    answer_if_told(device, StatusError::kNone, replies);
  } else if (packet.is(Instruction::kReboot)) {
    answer_if_told(device, StatusError::kNone, replies);
    device.reboot(now_ns);
  } else {
    answer_if_told(device, StatusError::kInstruction, replies);
  }
}

void DeviceBus::obey_write(Device& device, const dxl::Packet& packet, Replies& replies) {
  const auto request = dxl::as_write(packet);
  auto error = StatusError::kNone;
  if (!request) {
    error = StatusError::kDataLength;
  } else if (packet.is(Instruction::kRegWrite)) {
    registered_.emplace_back(&device, *request);
  } else {
    error = device.write(request->address, request->data);
  }
  answer_if_told(device, error, replies);
}

void DeviceBus::act(Device& device) {
  for (auto& [held_for, request] : registered_) {
    if (held_for == &device) (void)device.write(request.address, request.data);
  }
  registered_.erase(std::remove_if(registered_.begin(), registered_.end(),
                                   [&](const auto& entry) { return entry.first == &device; }),
                    registered_.end());
}

/// To the broadcast ID only a ping is answered, by each in the order of IDs.
void DeviceBus::obey_all(const dxl::Packet& packet, std::int64_t now_ns, Replies& replies) {
  for (Device* device : devices_) {
    if (!device->is_awake(now_ns)) continue;
    Replies own;
    obey_one(*device, packet, now_ns, own);
    if (packet.is(Instruction::kPing)) replies.insert(replies.end(), own.begin(), own.end());
  }
}

void DeviceBus::sync_read(const dxl::Packet& packet, std::int64_t now_ns, Replies& replies) {
  const auto request = dxl::as_sync_read(packet);
  if (!request || request->region.size > kMostRead) return;
  std::vector<const Device*> awake;
  for (const std::uint8_t id : request->ids) {
    const Device* device = find(id, now_ns);
    if (device == nullptr || device->status_return_level() < kReturnsReads) break;
    awake.push_back(device);
  }
  if (packet.is(Instruction::kFastSyncRead)) {
    answer_together(*request, awake, replies);
  } else {
    for (const Device* device : awake) {
      answer(*device, read_status(*device, request->region), replies);
    }
  }
}

void DeviceBus::sync_write(const dxl::Packet& packet, std::int64_t now_ns) {
  const auto request = dxl::as_sync_write(packet);
  if (!request) return;
  for (const dxl::SyncWriteItem& item : request->items) {
    Device* device = find(item.id, now_ns);
    if (device != nullptr) (void)device->write(request->region.address, item.data);
  }
}

}  // namespace scarab::emulator
