#include "tools/emulator/faults/effects.hpp"

namespace scarab::emulator {
namespace {

void silence(Effects& effects, const Fault& fault) {
  switch (fault.part) {
    case SilentPart::kJoint:
      effects.silent.set(fault.joint);
      break;
    case SilentPart::kImu:
      effects.imu_silent = true;
      break;
    case SilentPart::kBoard:
      effects.board_silent = true;
      break;
  }
}

void add(Effects& effects, const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::kLose:
      effects.lose = fault.value;
      break;
    case FaultKind::kFlip:
      effects.flip = fault.value;
      break;
    case FaultKind::kStuck:
      effects.stuck.set(fault.joint);
      break;
    case FaultKind::kSilent:
      silence(effects, fault);
      break;
    case FaultKind::kLate:
      effects.late_s = fault.value;
      break;
    case FaultKind::kUnplug:
      effects.unplugged = true;
      break;
    case FaultKind::kHot:
      effects.temperature_c[fault.joint] = fault.value;
      break;
    case FaultKind::kCurrent:
      effects.extra_current_a[fault.joint] = fault.value;
      break;
    case FaultKind::kTilt:
      effects.tilt_rad = fault.value;
      break;
    case FaultKind::kPose:
      effects.pose_rad[fault.joint] = fault.value;
      break;
  }
}

}  // namespace

Effects effects_of(const std::vector<Fault>& faults) {
  Effects effects;
  for (const Fault& fault : faults) add(effects, fault);
  return effects;
}

}  // namespace scarab::emulator
