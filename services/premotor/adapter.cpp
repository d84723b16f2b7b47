#include "services/premotor/adapter.hpp"

#include <algorithm>
#include <iterator>

namespace scarab::premotor {
namespace {

/// Calls f(message array, state array) for each pair of the two types: the one place that lists
/// them.
template <class Activity, class State, class F>
void for_each_array(Activity& activity, State& state, F f) {
  f(activity.input, state.input);
  f(activity.cpg, state.cpg);
  f(activity.psn1, state.psn1);
  f(activity.psn2, state.psn2);
  f(activity.psn3, state.psn3);
  f(activity.psn4, state.psn4);
  f(activity.vrn1, state.vrn1);
  f(activity.vrn2, state.vrn2);
  f(activity.delay_line, state.delay_line);
  f(activity.motor, state.motor);
}

}  // namespace

MotorIntent to_intent(const scarab_Behaviour& behaviour) {
  MotorIntent intent;
  intent.stop = behaviour.mode == scarab_MODE_STOP;
  std::copy(std::begin(behaviour.inputs), std::end(behaviour.inputs), intent.inputs.begin());
  if (behaviour.hind_override) {
    auto& pose = intent.hind_pose_rad.emplace();
    std::copy(std::begin(behaviour.hind_pose_rad), std::end(behaviour.hind_pose_rad), pose.begin());
  }
  intent.backbone_rad = behaviour.backbone_rad;
  return intent;
}

void fill(scarab_JointCommand& command, const robot::JointVector& targets_rad, bool stop) {
  command.kind = stop ? scarab_COMMAND_STOP : scarab_COMMAND_POSITION;
  std::copy(targets_rad.begin(), targets_rad.end(), std::begin(command.position_rad));
}

void fill(scarab_NeuralActivity& activity, const NetworkState& state) {
  for_each_array(activity, state, [](auto& to, const auto& from) {
    std::copy(from.begin(), from.end(), std::begin(to));
  });
}

NetworkState to_network_state(const scarab_NeuralActivity& activity) {
  NetworkState state;
  for_each_array(activity, state, [](const auto& from, auto& to) {
    std::copy(std::begin(from), std::end(from), to.begin());
  });
  return state;
}

}  // namespace scarab::premotor
