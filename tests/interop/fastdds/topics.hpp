#pragma once

#include <behaviourPubSubTypes.h>
#include <joint_commandPubSubTypes.h>
#include <neural_activityPubSubTypes.h>
#include <operatorPubSubTypes.h>
#include <robot_statePubSubTypes.h>
#include <service_statusPubSubTypes.h>
#include <trialPubSubTypes.h>
#include <world_statePubSubTypes.h>

#include "tests/interop/fastdds/qos.hpp"

/// The table of idl/README.md once more, as a vendor without Scarab's code would write it down.
namespace scarab::fastdds {

/// Support: the class that fastddsgen makes beside a type.
template <class Support>
struct Topic {
  const char* name;
  Profile profile;
};

inline constexpr Topic<RobotStatePubSubType> kRobotState{"scarab/robot_state", Profile::kState};
inline constexpr Topic<RobotStatePubSubType> kRobotSensors{"scarab/robot_sensors",
                                                           Profile::kStream};
inline constexpr Topic<BehaviourPubSubType> kBehaviour{"scarab/behaviour", Profile::kState};
inline constexpr Topic<JointCommandPubSubType> kJointCommand{"scarab/joint_command",
                                                             Profile::kCommand};
inline constexpr Topic<NeuralActivityPubSubType> kNeuralActivity{"scarab/neural_activity",
                                                                 Profile::kState};
inline constexpr Topic<WorldStatePubSubType> kWorldState{"scarab/world_state", Profile::kStream};
inline constexpr Topic<TrialPubSubType> kTrial{"scarab/trial", Profile::kState};
inline constexpr Topic<ServiceStatusPubSubType> kServiceStatus{"scarab/service_status",
                                                               Profile::kStatus};
inline constexpr Topic<OperatorPubSubType> kOperator{"scarab/operator", Profile::kCommand};

}  // namespace scarab::fastdds
