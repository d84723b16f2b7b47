#include <CLI/CLI.hpp>
#include <iostream>

#include "common/runtime/program.hpp"
#include "services/robot_bridge/calibrate/calibrate.hpp"
#include "services/robot_bridge/calibrate/console.hpp"

using namespace scarab;
using bridge::calibrate::Request;

int main(int argc, char** argv) {
  CLI::App app{
      "Finds how each servo of a robot sits in its joint, and writes the calibration file.",
      "scarab-calibrate"};
  app.footer(
      "Examples:\n"
      "  scarab-calibrate --robot config/robot/beetle.yaml \\\n"
      "    --config config/robot_bridge/beetle-dynamixel.yaml --output my-beetle.yaml\n"
      "  (the same again goes on with the joints that are left)\n"
      "  ... --joints CL0,FL0 --again     two joints anew, after a servo was changed\n"
      "  ... --pose start --yes           the robot stands in its start pose: offsets only\n"
      "  ... --check                      is the file right? writes nothing\n"
      "Motors are switched off however it ends; each joint is written as soon as it is known.\n"
      "Exit codes: 0 done, 1 joints left undone, off (--check) or robot lost, 2 bad usage or\n"
      "configuration, 130 interrupted.");
  Request request;
  app.add_option("--robot", request.robot, "robot description (YAML)")->required();
  app.add_option("--config", request.config, "robot bridge's configuration (YAML)")->required();
  app.add_option("--device", request.device, "port of the robot, in place of the configured one");
  app.add_option("--output", request.output,
                 "file to write or go on with, in place of the one that --config names");
  app.add_option("--joints", request.joints, "these only, such as TL0,CL0; all without")
      ->delimiter(',');
  app.add_option("--pose", request.pose, "pose that joints are put into: zero or start")
      ->check(CLI::IsMember({"zero", "start"}))
      ->capture_default_str();
  app.add_flag("--again", request.again, "also joints that have an entry");
  app.add_flag("--yes", request.yes, "ask nobody: the robot stands in the pose; offsets only");
  app.add_flag("--check", request.check, "compare the file with the robot; write nothing");
  app.add_option("--tolerance-rad", request.tolerance_rad, "largest difference for --check")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  return runtime::run_program(app, argc, argv, [&] {
    try {
      return bridge::calibrate::calibrate(request);
    } catch (const bridge::calibrate::BadRequest& bad) {
      throw CLI::ValidationError(bad.option(), bad.what());
    } catch (const bridge::calibrate::Interrupted&) {
      std::cerr << "scarab-calibrate: interrupted; joints that were done are written\n";
      return runtime::kExitInterrupted;
    }
  });
}
