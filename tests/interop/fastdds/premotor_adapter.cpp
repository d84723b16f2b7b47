#include "tests/interop/fastdds/premotor_adapter.hpp"

namespace scarab::fastdds {

premotor::MotorIntent to_intent(const Behaviour& behaviour) {
  premotor::MotorIntent intent;
  intent.stop = behaviour.mode() == MODE_STOP;
  intent.inputs = behaviour.inputs();
  if (behaviour.hind_override()) intent.hind_pose_rad = behaviour.hind_pose_rad();
  intent.backbone_rad = behaviour.backbone_rad();
  return intent;
}

void fill(NeuralActivity& activity, const premotor::NetworkState& state) {
  activity.input(state.input);
  activity.cpg(state.cpg);
  activity.psn1(state.psn1);
  activity.psn2(state.psn2);
  activity.psn3(state.psn3);
  activity.psn4(state.psn4);
  activity.vrn1(state.vrn1);
  activity.vrn2(state.vrn2);
  activity.delay_line(state.delay_line);
  activity.motor(state.motor);
}

void fill(JointCommand& command, const robot::JointVector& targets_rad, bool stop) {
  command.kind(stop ? COMMAND_STOP : COMMAND_POSITION);
  command.position_rad(targets_rad);
}

}  // namespace scarab::fastdds
