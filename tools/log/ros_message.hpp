#pragma once

#include <string>

#include "common/sample/type_model.hpp"

namespace scarab::log {

/// The type of a ROS 2 message definition, as rosbag2 keeps it in its files (schema encoding
/// `ros2msg`): the definition of `type_name` (such as sensor_msgs/msg/JointState), then those of
/// all it is made of, each after a line of `=` and a line `MSG: package/Type`. Constants and
/// default values are skipped. Throws bus::Error `line N: ...` for what is none, and for wide
/// strings.
sample::TypeModel parse_ros_message(const std::string& text, const std::string& type_name);

}  // namespace scarab::log
