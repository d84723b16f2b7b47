#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/bus.hpp"
#include "services/robot_bridge/drivers/dynamixel/servo.hpp"

namespace scarab::bridge::dynamixel {

/// Names a value of a control table.
using ItemOf = Item ServoModel::*;

/// One count of each servo of a group, in its order.
using Counts = std::vector<std::int64_t>;

/// All servos of a robot as one: values of all of them with one instruction. Everything throws what
/// the bus throws.
class ServoGroup {
 public:
  /// At least one servo, and one layout of all control tables.
  ServoGroup(Bus& bus, std::vector<Servo> servos, SyncReadKind kind);

  [[nodiscard]] const std::vector<Servo>& servos() const { return servos_; }
  [[nodiscard]] std::size_t size() const { return servos_.size(); }
  [[nodiscard]] Bus& bus() { return bus_; }
  [[nodiscard]] SyncReadKind kind() const { return kind_; }
  /// "joint TL0 (ID 3)".
  [[nodiscard]] std::string name_of(std::size_t index) const {
    return bus_.name_of(servos_[index].id);
  }

  /// Where an item is, in all of the servos.
  [[nodiscard]] Region region(ItemOf item) const { return (servos_.front().model.*item).region(); }
  /// The answers in the servos' order.
  std::vector<Status> read(Region region) { return bus_.read_all(region, ids_, kind_); }

  Counts read(ItemOf item);
  /// Nobody confirms it: read() it where it matters.
  void write(ItemOf item, const Counts& counts);
  void write(ItemOf item, std::int64_t count) { write(item, Counts(size(), count)); }
  /// What write() would send.
  [[nodiscard]] Packet write_instruction(ItemOf item, const Counts& counts) const;

  /// One servo for itself; what it answers with an error throws.
  std::int64_t read_one(std::size_t index, ItemOf item);
  void write_one(std::size_t index, ItemOf item, std::int64_t count);

 private:
  Bus& bus_;
  std::vector<Servo> servos_;
  std::vector<std::uint8_t> ids_;
  SyncReadKind kind_;
};

}  // namespace scarab::bridge::dynamixel
