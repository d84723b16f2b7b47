#include "services/robot_bridge/drivers/dynamixel/config.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "common/robot/joints.hpp"

namespace scarab::bridge::dynamixel {
namespace {

bool is_joint(const std::string& name) {
  return std::find(robot::kJointNames.begin(), robot::kJointNames.end(), name) !=
         robot::kJointNames.end();
}

/// What a sync instruction asks of all servos at once must lie at one place in all of them.
bool share_a_layout(const ServoModel& a, const ServoModel& b) {
  std::vector<Region> of_a;
  std::vector<Region> of_b;
  for_each_item(a, [&](std::string_view, const Item& item) { of_a.push_back(item.region()); });
  for_each_item(b, [&](std::string_view, const Item& item) { of_b.push_back(item.region()); });
  return of_a == of_b;
}

void require_new_id(std::set<int>& taken, std::uint8_t id, const std::string& key,
                    const config::Check& check) {
  check.require(taken.insert(id).second, key, "is the ID of another device, too");
}

}  // namespace

void validate(const Item& c, const config::Check& check) {
  check.require(c.unit != 0, "unit", "must not be 0");
}

void validate(const Config& c, const config::Check& check) {
  check.require(!c.servos.empty(), "servos", "needs at least one joint");
  std::set<int> taken;
  std::optional<ServoModel> first;
  for (const auto& [joint, servo] : c.servos) {
    const std::string key = "servos." + joint;
    check.require(is_joint(joint), key, "is no joint (TL0 .. FR2, BJ)");
    require_new_id(taken, servo.id, key + ".id", check);
    const auto model = find_model(c, servo.model);
    check.require(model.has_value(), key + ".model",
                  "no such model: " + std::string(kBuiltInModel) + " or one of `models`");
    if (!first) first = model;
    check.require(
        share_a_layout(*first, *model), key + ".model",
        "has its values at other addresses than the other servos; they are read together");
  }
  if (c.imu) require_new_id(taken, c.imu->id, "imu.id", check);
  if (c.foot_force) require_new_id(taken, c.foot_force->id, "foot_force.id", check);
}

std::optional<ServoModel> find_model(const Config& config, const std::string& name) {
  const auto found = config.models.find(name);
  if (found != config.models.end()) return found->second;
  if (name == kBuiltInModel) return ServoModel{};
  return std::nullopt;
}

}  // namespace scarab::bridge::dynamixel
