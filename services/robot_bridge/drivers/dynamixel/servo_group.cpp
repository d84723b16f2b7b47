#include "services/robot_bridge/drivers/dynamixel/servo_group.hpp"

#include <stdexcept>

namespace scarab::bridge::dynamixel {

ServoGroup::ServoGroup(Bus& bus, std::vector<Servo> servos, SyncReadKind kind)
    : bus_(bus), servos_(std::move(servos)), kind_(kind) {
  if (servos_.empty()) throw std::invalid_argument("dynamixel: a robot without servos");
  for (const Servo& servo : servos_) ids_.push_back(servo.id);
}

Counts ServoGroup::read(ItemOf item) {
  const std::vector<Status> answers = read(region(item));
  Counts counts;
  for (std::size_t i = 0; i < size(); ++i) {
    counts.push_back(count_in(servos_[i].model.*item, answers[i].data));
  }
  return counts;
}

Packet ServoGroup::write_instruction(ItemOf item, const Counts& counts) const {
  SyncWriteRequest request{region(item), {}};
  for (std::size_t i = 0; i < size(); ++i) {
    request.items.push_back({servos_[i].id, bytes_of(servos_[i].model.*item, counts[i])});
  }
  return sync_write(request);
}

void ServoGroup::write(ItemOf item, const Counts& counts) {
  bus_.tell(write_instruction(item, counts));
}

std::int64_t ServoGroup::read_one(std::size_t index, ItemOf item) {
  const Item& of = servos_[index].model.*item;
  const Status answer = bus_.ask(dynamixel::read(servos_[index].id, of.region()), of.size());
  return count_in(of, answer.data);
}

void ServoGroup::write_one(std::size_t index, ItemOf item, std::int64_t count) {
  const Item& of = servos_[index].model.*item;
  bus_.ask(dynamixel::write(servos_[index].id, of.address, bytes_of(of, count)), 0);
}

}  // namespace scarab::bridge::dynamixel
