#include "tests/system/walk.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "common/bus/cdr.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/reader.hpp"

namespace scarab::test {
namespace {

template <class T>
T decode(const mcap::Message& message) {
  return *bus::decode<T>(
      {reinterpret_cast<const std::byte*>(message.data.data()), message.data.size()});
}

Eigen::Quaterniond turn(const scarab_Pose& pose) {
  const auto& q = pose.orientation_wxyz;
  return {q[0], q[1], q[2], q[3]};
}

Eigen::Vector3d place(const scarab_Pose& pose) {
  return {pose.position_m[0], pose.position_m[1], pose.position_m[2]};
}

double yaw(const scarab_Pose& pose) {
  const Eigen::Vector3d forward = turn(pose) * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

double tilt(const scarab_Pose& pose) {
  return std::acos(std::clamp((turn(pose) * Eigen::Vector3d::UnitZ()).z(), -1.0, 1.0));
}

/// Takes in the poses of the trunk, one after the other.
class Track {
 public:
  void add(const scarab_WorldState& world) {
    const scarab_Pose& pose = world.trunk;
    if (!start_) {
      start_ = pose;
      walk_.height_least_m = pose.position_m[2];
    }
    walk_.turned_rad += std::remainder(yaw(pose) - last_yaw_.value_or(yaw(pose)), 2 * M_PI);
    last_yaw_ = yaw(pose);
    const Eigen::Vector3d way =
        Eigen::AngleAxisd(-yaw(*start_), Eigen::Vector3d::UnitZ()) * (place(pose) - place(*start_));
    walk_.time_s = static_cast<double>(world.header.sim_time_ns) * 1e-9;
    walk_.ahead_m = way.x();
    walk_.sideways_m = way.y();
    walk_.tilt_most_rad = std::max(walk_.tilt_most_rad, tilt(pose));
    walk_.height_least_m = std::min(walk_.height_least_m, pose.position_m[2]);
  }

  [[nodiscard]] const Walk& walk() const {
    if (!start_) throw std::runtime_error("the log has no trial in it");
    return walk_;
  }

 private:
  Walk walk_;
  std::optional<scarab_Pose> start_;
  std::optional<double> last_yaw_;
};

bool absent(const scarab_RobotState& state, std::size_t slot) {
  return state.position_source[slot] == scarab_SOURCE_ABSENT &&
         state.velocity_source[slot] == scarab_SOURCE_ABSENT &&
         state.torque_source[slot] == scarab_SOURCE_ABSENT && state.position_rad[slot] == 0 &&
         state.velocity_rad_s[slot] == 0 && state.torque_nm[slot] == 0;
}

}  // namespace

Walk read_walk(const std::filesystem::path& log) {
  Track track;
  std::vector<robot::JointVector> targets;
  std::array<std::size_t, robot::kLegCount> in_air{};
  std::size_t sensed = 0;
  mcap::Reader(log).for_each(
      [&](const mcap::Channel& channel, const mcap::Message& message) {
        if (channel.topic == bus::kWorldState.name) {
          track.add(decode<scarab_WorldState>(message));
        } else if (channel.topic == bus::kJointCommand.name) {
          const auto command = decode<scarab_JointCommand>(message);
          std::copy(std::begin(command.position_rad), std::end(command.position_rad),
                    targets.emplace_back().begin());
        } else {
          const auto state = decode<scarab_RobotState>(message);
          ++sensed;
          for (std::size_t leg = 0; leg < in_air.size(); ++leg) {
            if (state.foot_force_n[leg] == 0) ++in_air[leg];
          }
        }
      },
      {bus::kWorldState.name, bus::kJointCommand.name, bus::kRobotSensors.name});
  Walk walk = track.walk();
  walk.targets_rad = std::move(targets);
  for (std::size_t leg = 0; leg < in_air.size(); ++leg) {
    walk.air_share[leg] = static_cast<double>(in_air[leg]) / static_cast<double>(sensed);
  }
  return walk;
}

std::size_t traces_of_joint(const std::filesystem::path& log, std::size_t slot) {
  std::size_t traces = 0;
  mcap::Reader(log).for_each(
      [&](const mcap::Channel& channel, const mcap::Message& message) {
        const bool command = channel.topic == bus::kJointCommand.name;
        const bool clean = command ? decode<scarab_JointCommand>(message).position_rad[slot] == 0
                                   : absent(decode<scarab_RobotState>(message), slot);
        if (!clean) ++traces;
      },
      {bus::kRobotState.name, bus::kRobotSensors.name, bus::kJointCommand.name});
  return traces;
}

}  // namespace scarab::test
