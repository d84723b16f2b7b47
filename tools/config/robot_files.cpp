#include "tools/config/robot_files.hpp"

#include <array>
#include <string>

#include "common/config/check.hpp"
#include "common/config/extends.hpp"
#include "common/config/robot_file.hpp"
#include "common/config/scalar.hpp"
#include "services/plant/config.hpp"
#include "services/premotor/config.hpp"
#include "services/robot_bridge/calibration_file.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/supervisor/config.hpp"

namespace scarab::config_tool {
namespace {

using config::format_number;
using Path = std::filesystem::path;

constexpr std::array<const char*, 3> kRowNames = {"front", "middle", "hind"};
constexpr std::array<const char*, 3> kLegJointNames = {"thoraco-coxal", "coxa-trochanteral",
                                                       "femur-tibia"};

/// A file's values and where they stand. A check points into it, so it must stay in its place
/// meanwhile.
template <class T>
class File {
 public:
  File(const Path& path, T value)
      : path_(path.string()), value_(std::move(value)), document_(config::read_extended(path)) {}

  [[nodiscard]] const T& value() const { return value_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] config::Check check() const { return config::Check(config::Cursor(document_)); }

 private:
  std::string path_;
  T value_;
  config::Document document_;
};

using RobotFile = File<robot::RobotModel>;
using PlantFile = File<plant::PlantConfig>;
using PremotorFile = File<premotor::PremotorConfig>;
using SupervisorFile = File<supervisor::SupervisorConfig>;
using BridgeFile = File<bridge::BridgeConfig>;

template <class T>
std::optional<File<T>> read(const std::optional<Path>& path, T (*load)(const Path&)) {
  if (!path) return std::nullopt;
  return File<T>(*path, load(*path));
}

/// The value of a key is told to joints of a robot.
class Aim {
 public:
  Aim(config::Check check, const RobotFile& robot) : check_(std::move(check)), robot_(robot) {}

  void backbone(const std::string& key, double angle_rad) const {
    expect(key, angle_rad, robot_.value().joints[robot::kBackboneSlot], "backbone");
  }

  /// One joint of a row of legs; left and right have the same range.
  void leg_joint(const std::string& key, double angle_rad, std::size_t row,
                 std::size_t joint) const {
    const auto left = static_cast<robot::Leg>(row);
    const auto slot = robot::joint_slot(left, static_cast<robot::LegJoint>(joint));
    expect(key, angle_rad, robot_.value().joints[slot],
           std::string(kRowNames[row]) + " " + kLegJointNames[joint]);
  }

  /// T, C, F of a row of legs.
  void legs(const std::string& key, const std::array<double, 3>& angles_rad,
            std::size_t row) const {
    for (std::size_t joint = 0; joint < 3; ++joint) leg_joint(key, angles_rad[joint], row, joint);
  }

 private:
  void expect(const std::string& key, double angle_rad, const robot::Joint& joint,
              const std::string& name) const {
    const bool inside = angle_rad >= joint.min_rad && angle_rad <= joint.max_rad;
    check_.require(!joint.present || inside, key,
                   format_number(angle_rad) + " is outside of the " + name + " joint's range [" +
                       format_number(joint.min_rad) + ", " + format_number(joint.max_rad) +
                       "] in " + robot_.path());
  }

  config::Check check_;
  const RobotFile& robot_;
};

/// How the robot stands at the start: the plant's, or the bridge's.
template <class Start>
void expect_start(const Aim& aim, const Start& start) {
  aim.legs("start.front_rad", start.front_rad, 0);
  aim.legs("start.middle_rad", start.middle_rad, 1);
  aim.legs("start.hind_rad", start.hind_rad, 2);
  aim.backbone("start.backbone_rad", start.backbone_rad);
}

void expect_match(const PlantFile& plant, const RobotFile& robot) {
  expect_start(Aim(plant.check(), robot), plant.value().start);
}

void expect_match(const BridgeFile& bridge, const RobotFile& robot) {
  expect_start(Aim(bridge.check(), robot), bridge.value().start);
}

void expect_match(const BridgeFile& bridge, const PlantFile& plant) {
  const config::Check check = bridge.check();
  const auto same = [&](const char* key, const auto& here, const auto& there) {
    check.require(here == there, key, "differs from " + plant.path());
  };
  const bridge::StartPose& start = bridge.value().start;
  const plant::StartConfig& other = plant.value().start;
  same("start.front_rad", start.front_rad, other.front_rad);
  same("start.middle_rad", start.middle_rad, other.middle_rad);
  same("start.hind_rad", start.hind_rad, other.hind_rad);
  same("start.backbone_rad", start.backbone_rad, other.backbone_rad);
  same("timing.control_period_s", bridge.value().timing.control_period_s,
       plant.value().timing.control_period_s);
}

void expect_match(const PremotorFile& premotor, const RobotFile& robot) {
  const Aim aim(premotor.check(), robot);
  const premotor::MotorConfig& motor = premotor.value().motor;
  const std::array<const premotor::MotorRowConfig*, 3> rows = {&motor.front, &motor.middle,
                                                               &motor.hind};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::string key = "motor." + std::string(kRowNames[row]);
    aim.leg_joint(key + ".t_offset_rad", rows[row]->t_offset_rad, row, 0);
    aim.leg_joint(key + ".c_offset_rad", rows[row]->c_offset_rad, row, 1);
    aim.leg_joint(key + ".f_offset_rad", rows[row]->f_offset_rad, row, 2);
  }
}

void expect_match(const SupervisorFile& supervisor, const RobotFile& robot) {
  const Aim aim(supervisor.check(), robot);
  aim.backbone("backbone_rad", supervisor.value().backbone_rad);
  aim.legs("stationary_hind_pose_rad", supervisor.value().stationary_hind_pose_rad, 2);
}

void expect_match(const SupervisorFile& supervisor, const PremotorFile& premotor) {
  const double compared_rad = supervisor.value().as.reference_rad;
  const double told_rad = premotor.value().motor.front.f_offset_rad;
  supervisor.check().require(compared_rad == told_rad, "as.reference_rad",
                             format_number(compared_rad) + " is not " + format_number(told_rad) +
                                 ", motor.front.f_offset_rad of " + premotor.path());
}

}  // namespace

void expect_match(const RobotFiles& files) {
  const auto robot = read(files.robot, config::load_robot);
  const auto plant = read(files.plant, plant::load_config);
  const auto premotor = read(files.premotor, premotor::load_config);
  const auto supervisor = read(files.supervisor, supervisor::load_config);
  const auto bridge = read(files.robot_bridge, bridge::load_config);
  if (bridge && robot) expect_match(*bridge, *robot);
  if (bridge && plant) expect_match(*bridge, *plant);
  if (bridge && robot) (void)bridge::load_calibration(bridge->value().calibration, robot->value());
  if (files.calibration && robot) {
    (void)bridge::load_calibration(*files.calibration, robot->value());
  }
  if (plant && robot) expect_match(*plant, *robot);
  if (premotor && robot) expect_match(*premotor, *robot);
  if (supervisor && robot) expect_match(*supervisor, *robot);
  if (supervisor && premotor) expect_match(*supervisor, *premotor);
}

}  // namespace scarab::config_tool
