#include "tests/unit/robot_bridge/dynamixel/scripted_bus.hpp"

#include <chrono>
#include <utility>

#include "services/robot_bridge/drivers/dynamixel/protocol/fast_status.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"

namespace scarab::bridge::dynamixel {
namespace {

// Addresses of the XM430-W350 in the manual, written down a second time.
constexpr std::size_t kTorque = 64;
constexpr std::size_t kHardwareError = 70;
constexpr std::size_t kWatchdog = 98;
constexpr std::size_t kGoal = 116;

StatusError write_into(ScriptedDevice& device, std::size_t address, const Bytes& data) {
  if (device.lost_writes > 0) {
    --device.lost_writes;
    return StatusError::kNone;
  }
  ScriptedDevice after = device;
  for (std::size_t i = 0; i < data.size(); ++i) after.memory.at(address + i) = data[i];
  if (address < kTorque && device.memory[kTorque] != 0) return StatusError::kAccess;
  if (address == kGoal) {
    if (device.memory[kWatchdog] == 0xFF) return StatusError::kDataRange;
    if (after.get(kGoal, 4) < device.get(52, 4) || after.get(kGoal, 4) > device.get(48, 4)) {
      return StatusError::kDataLimit;
    }
  }
  if (address == kTorque && data[0] != 0 && device.memory[kHardwareError] != 0) {
    return StatusError::kNone;  // stays off
  }
  device = after;
  return StatusError::kNone;
}

Bytes part(const ScriptedDevice& device, Region region) {
  const auto from = device.memory.begin() + region.address;
  return Bytes(from, from + region.size);
}

Status status_of(std::uint8_t id, const ScriptedDevice& device, Bytes data = {}) {
  return {id, device.memory[kHardwareError] != 0, StatusError::kNone, std::move(data)};
}

}  // namespace

ScriptedDevice ScriptedDevice::servo(int ticks) {
  ScriptedDevice device;
  device.memory[9] = 250;
  device.memory[11] = 3;
  device.memory[31] = 80;
  device.set(48, 4, 4095);
  device.memory[63] = 52;
  device.memory[68] = 2;
  device.set(132, 4, ticks);
  device.memory[146] = 30;
  return device;
}

std::int32_t ScriptedDevice::get(std::size_t address, std::size_t size) const {
  return static_cast<std::int32_t>(read_little({memory.data() + address, size}));
}

void ScriptedDevice::set(std::size_t address, std::size_t size, std::int64_t value) {
  for (std::size_t i = 0; i < size; ++i) {
    memory.at(address + i) = static_cast<std::uint8_t>(value >> (8 * i));
  }
}

ScriptedBus::ScriptedBus(std::map<std::uint8_t, ScriptedDevice> devices)
    : devices_(std::move(devices)), thread_([this] { run(); }) {}

ScriptedBus::~ScriptedBus() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    end_ = true;
  }
  ending_.notify_all();
  thread_.join();
}

void ScriptedBus::script(Script script) {
  const std::lock_guard<std::mutex> lock(mutex_);
  script_ = std::move(script);
}

void ScriptedBus::change(std::uint8_t id, const std::function<void(ScriptedDevice&)>& change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  change(devices_.at(id));
}

ScriptedDevice ScriptedBus::device(std::uint8_t id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return devices_.at(id);
}

std::vector<Packet> ScriptedBus::heard() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return heard_;
}

void ScriptedBus::forget_heard() {
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_.clear();
}

void ScriptedBus::unplug() {
  const std::lock_guard<std::mutex> lock(mutex_);
  line_.unplug();
  unplug_ = true;
}

void ScriptedBus::run() {
  Parser parser;
  std::vector<Packet> packets;
  std::unique_lock<std::mutex> lock(mutex_);
  while (!end_ && !unplug_) {
    const Bytes bytes = line_.read(kMaxFrameBytes, std::chrono::milliseconds(0));
    packets.clear();
    parser.feed(bytes, packets);
    for (const Packet& packet : packets) answer(packet);
    if (bytes.empty()) ending_.wait_for(lock, std::chrono::microseconds(200));
  }
}

void ScriptedBus::answer(const Packet& instruction) {
  heard_.push_back(instruction);
  Bytes bytes = reply(instruction);
  if (script_) bytes = script_(instruction, std::move(bytes));
  if (!bytes.empty()) line_.write(bytes);
}

Bytes ScriptedBus::reply(const Packet& instruction) {
  if (const auto request = as_sync_write(instruction)) {
    for (const SyncWriteItem& item : request->items) {
      const auto found = devices_.find(item.id);
      if (found != devices_.end() && !found->second.silent) {
        write_into(found->second, request->region.address, item.data);
      }
    }
    return {};
  }
  if (as_sync_read(instruction)) return reply_of_all(instruction);
  const auto found = devices_.find(instruction.id);
  if (found == devices_.end() || found->second.silent) return {};
  return reply_to_one(found->second, instruction);
}

Bytes ScriptedBus::reply_to_one(ScriptedDevice& device, const Packet& instruction) {
  Status status = status_of(instruction.id, device);
  if (instruction.is(Instruction::kPing)) {
    status.data = to_data({device.model_number, device.firmware});
  } else if (const auto region = as_read(instruction)) {
    status.data = part(device, *region);
  } else if (const auto request = as_write(instruction)) {
    status.error = write_into(device, request->address, request->data);
  } else {
    status.error = StatusError::kInstruction;
  }
  return encode(to_packet(status));
}

/// Each waits for the one before it: behind a silent one nobody answers.
Bytes ScriptedBus::reply_of_all(const Packet& instruction) {
  const auto request = as_sync_read(instruction);
  std::vector<Status> statuses;
  std::vector<bool> speaks;
  for (const std::uint8_t id : request->ids) {
    const auto found = devices_.find(id);
    const bool there = found != devices_.end() && !found->second.silent;
    const ScriptedDevice device = there ? found->second : ScriptedDevice{};
    statuses.push_back(status_of(id, device, part(device, request->region)));
    speaks.push_back(there);
  }
  const bool fast = instruction.is(Instruction::kFastSyncRead);
  const std::vector<Bytes> chunks = fast ? encode_fast_status(statuses) : std::vector<Bytes>{};
  Bytes bytes;
  for (std::size_t i = 0; i < statuses.size() && speaks[i]; ++i) {
    const Bytes next = fast ? chunks[i] : encode(to_packet(statuses[i]));
    bytes.insert(bytes.end(), next.begin(), next.end());
  }
  return bytes;
}

}  // namespace scarab::bridge::dynamixel
