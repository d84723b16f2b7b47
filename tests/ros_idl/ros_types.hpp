#pragma once

#include <vector>

#include "common/bus/topic_type.hpp"

namespace scarab::test {

/// The topic types of this folder's IDL: common messages of ROS 2, under the names they have on DDS
/// (`sensor_msgs::msg::dds_::JointState_`).
std::vector<const dds_topic_descriptor_t*> ros_types();

}  // namespace scarab::test
