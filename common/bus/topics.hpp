#pragma once

#include "common/bus/profile.hpp"
#include "common/bus/topic.hpp"

/// The one list of topics: name, type and profile, declared here and nowhere else.
namespace scarab::bus {

inline constexpr Topic<scarab_RobotState> kRobotState{"scarab/robot_state", Profile::kState};
inline constexpr Topic<scarab_RobotState> kRobotSensors{"scarab/robot_sensors", Profile::kStream};
inline constexpr Topic<scarab_Behaviour> kBehaviour{"scarab/behaviour", Profile::kState};
inline constexpr Topic<scarab_JointCommand> kJointCommand{"scarab/joint_command",
                                                          Profile::kCommand};
inline constexpr Topic<scarab_NeuralActivity> kNeuralActivity{"scarab/neural_activity",
                                                              Profile::kState};
inline constexpr Topic<scarab_WorldState> kWorldState{"scarab/world_state", Profile::kStream};
inline constexpr Topic<scarab_Trial> kTrial{"scarab/trial", Profile::kState};
inline constexpr Topic<scarab_ServiceStatus> kServiceStatus{"scarab/service_status",
                                                            Profile::kStatus};
inline constexpr Topic<scarab_Operator> kOperator{"scarab/operator", Profile::kCommand};

/// Calls f(topic) for each topic of the list.
template <class F>
void for_each_topic(F&& f) {
  f(kRobotState);
  f(kRobotSensors);
  f(kBehaviour);
  f(kJointCommand);
  f(kNeuralActivity);
  f(kWorldState);
  f(kTrial);
  f(kServiceStatus);
  f(kOperator);
}

}  // namespace scarab::bus
