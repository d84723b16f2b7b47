#include "tests/system/robot_bridge/recorded_trial.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "common/bus/cdr.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/reader.hpp"
#include "common/runtime/words.hpp"

namespace scarab::test {
namespace {

template <class T>
T decode(const mcap::Message& message) {
  return *bus::decode<T>(
      {reinterpret_cast<const std::byte*>(message.data.data()), message.data.size()});
}

void add(RecordedTrial& trial, const scarab_RobotState& state) {
  if (state.header.tick < trial.position_rad.size()) return;  // a late joiner was told it again
  if (state.header.tick > trial.position_rad.size()) {
    throw std::runtime_error("robot_state " + std::to_string(trial.position_rad.size()) +
                             " is missing");
  }
  robot::JointVector position_rad{};
  std::copy(std::begin(state.position_rad), std::end(state.position_rad), position_rad.begin());
  trial.position_rad.push_back(position_rad);
}

}  // namespace

RecordedTrial read_recorded_trial(const std::filesystem::path& log) {
  RecordedTrial trial;
  std::optional<scarab_BehaviourState> state;
  std::optional<std::size_t> approach;
  const mcap::Reader reader(log);
  reader.for_each(
      [&](const mcap::Channel& channel, const mcap::Message& message) {
        if (channel.topic == bus::kRobotState.name) {
          add(trial, decode<scarab_RobotState>(message));
          return;
        }
        const auto behaviour = decode<scarab_Behaviour>(message);
        if (state == behaviour.state) return;
        state = behaviour.state;
        trial.behaviours.push_back(runtime::word(behaviour.state));
        if (state == scarab_BEHAVIOUR_APPROACH && !approach) approach = behaviour.header.tick;
      },
      {bus::kRobotState.name, bus::kBehaviour.name});
  if (!approach) throw std::runtime_error(log.string() + ": nobody approaches anything");
  trial.walks_from = *approach;
  return trial;
}

double rms_difference_rad(const RecordedTrial& a, const RecordedTrial& b, std::size_t ticks) {
  double sum = 0;
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    const auto& left = a.position_rad.at(a.walks_from + tick);
    const auto& right = b.position_rad.at(b.walks_from + tick);
    for (std::size_t slot = 0; slot < left.size(); ++slot) {
      sum += std::pow(left[slot] - right[slot], 2);
    }
  }
  return std::sqrt(sum / static_cast<double>(ticks * robot::kJointCount));
}

}  // namespace scarab::test
