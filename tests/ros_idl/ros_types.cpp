#include "tests/ros_idl/ros_types.hpp"

#include <builtin_interfaces.h>
#include <diagnostic_msgs.h>
#include <geometry_msgs.h>
#include <nav_msgs.h>
#include <rosgraph_msgs.h>
#include <sensor_msgs.h>
#include <std_msgs.h>
#include <tf2_msgs.h>
#include <trajectory_msgs.h>

namespace scarab::test {

std::vector<const dds_topic_descriptor_t*> ros_types() {
  return {
      &builtin_interfaces_msg_dds__Time__desc,
      &builtin_interfaces_msg_dds__Duration__desc,
      &std_msgs_msg_dds__Header__desc,
      &std_msgs_msg_dds__Empty__desc,
      &std_msgs_msg_dds__String__desc,
      &std_msgs_msg_dds__Bool__desc,
      &std_msgs_msg_dds__Float64__desc,
      &std_msgs_msg_dds__Int32__desc,
      &std_msgs_msg_dds__ColorRGBA__desc,
      &std_msgs_msg_dds__MultiArrayDimension__desc,
      &std_msgs_msg_dds__MultiArrayLayout__desc,
      &std_msgs_msg_dds__Float64MultiArray__desc,
      &geometry_msgs_msg_dds__Vector3__desc,
      &geometry_msgs_msg_dds__Point__desc,
      &geometry_msgs_msg_dds__Quaternion__desc,
      &geometry_msgs_msg_dds__Pose__desc,
      &geometry_msgs_msg_dds__PoseStamped__desc,
      &geometry_msgs_msg_dds__PoseWithCovariance__desc,
      &geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc,
      &geometry_msgs_msg_dds__Twist__desc,
      &geometry_msgs_msg_dds__TwistStamped__desc,
      &geometry_msgs_msg_dds__TwistWithCovariance__desc,
      &geometry_msgs_msg_dds__Wrench__desc,
      &geometry_msgs_msg_dds__Transform__desc,
      &geometry_msgs_msg_dds__TransformStamped__desc,
      &sensor_msgs_msg_dds__JointState__desc,
      &sensor_msgs_msg_dds__Imu__desc,
      &sensor_msgs_msg_dds__Image__desc,
      &sensor_msgs_msg_dds__CompressedImage__desc,
      &sensor_msgs_msg_dds__LaserScan__desc,
      &sensor_msgs_msg_dds__PointField__desc,
      &sensor_msgs_msg_dds__PointCloud2__desc,
      &sensor_msgs_msg_dds__BatteryState__desc,
      &sensor_msgs_msg_dds__Joy__desc,
      &sensor_msgs_msg_dds__NavSatStatus__desc,
      &sensor_msgs_msg_dds__NavSatFix__desc,
      &nav_msgs_msg_dds__Odometry__desc,
      &nav_msgs_msg_dds__Path__desc,
      &nav_msgs_msg_dds__MapMetaData__desc,
      &nav_msgs_msg_dds__OccupancyGrid__desc,
      &tf2_msgs_msg_dds__TFMessage__desc,
      &diagnostic_msgs_msg_dds__KeyValue__desc,
      &diagnostic_msgs_msg_dds__DiagnosticStatus__desc,
      &diagnostic_msgs_msg_dds__DiagnosticArray__desc,
      &rosgraph_msgs_msg_dds__Clock__desc,
      &trajectory_msgs_msg_dds__JointTrajectoryPoint__desc,
      &trajectory_msgs_msg_dds__JointTrajectory__desc,
  };
}

}  // namespace scarab::test
