#pragma once

#include <dds/dds.h>
#include <scarab/behaviour.h>
#include <scarab/joint_command.h>
#include <scarab/neural_activity.h>
#include <scarab/operator.h>
#include <scarab/robot_state.h>
#include <scarab/service_status.h>
#include <scarab/trial.h>
#include <scarab/world_state.h>

#include "common/bus/profile.hpp"

namespace scarab::bus {

/// A topic: its name, the C type that idlc generates from its IDL type, and its QoS profile.
template <class T>
struct Topic {
  using Type = T;
  const char* name;
  Profile profile;
};

/// The topic descriptor idlc generated for T. A new topic type needs one line here.
template <class T>
const dds_topic_descriptor_t& descriptor();

// idlc knows no C++: its descriptors have names made from the type's name, so that a macro is the
// only way not to write each name four times.
#define SCARAB_BUS_TYPE(type)                               \
  template <>                                               \
  inline const dds_topic_descriptor_t& descriptor<type>() { \
    return type##_desc;                                     \
  }
SCARAB_BUS_TYPE(scarab_RobotState)
SCARAB_BUS_TYPE(scarab_Behaviour)
SCARAB_BUS_TYPE(scarab_JointCommand)
SCARAB_BUS_TYPE(scarab_NeuralActivity)
SCARAB_BUS_TYPE(scarab_WorldState)
SCARAB_BUS_TYPE(scarab_Trial)
SCARAB_BUS_TYPE(scarab_ServiceStatus)
SCARAB_BUS_TYPE(scarab_Operator)
#undef SCARAB_BUS_TYPE

}  // namespace scarab::bus
