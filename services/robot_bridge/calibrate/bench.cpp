#include "services/robot_bridge/calibrate/bench.hpp"

#include "common/config/robot_file.hpp"
#include "services/robot_bridge/calibrate/own_scales.hpp"
#include "services/robot_bridge/core/start_pose.hpp"
#include "services/robot_bridge/driver_choice.hpp"

namespace scarab::bridge::calibrate {

Bench::Bench(const Request& request)
    : request_(request),
      config_(load_config(request.config)),
      robot_(config::load_robot(request.robot)) {
  if (request.pose == "start") reference_rad_ = joint_targets(config_.start);
}

void Bench::set_up(const Calibration& known) {
  scales_ = own_scales(robot_);
  driver_ = make_driver(request_.config, config_, robot_, scales_, request_.device);
  tells_angles_ = driver_->capabilities().position_feedback;
  if (tells_angles_) return;
  scales_ = own_scales(robot_, known);
  driver_ = make_driver(request_.config, config_, robot_, scales_, request_.device);
}

Bench::~Bench() {
  if (!driver_) return;
  (void)driver_->release();
  driver_->close();
}

}  // namespace scarab::bridge::calibrate
