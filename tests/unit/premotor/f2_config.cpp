#include "tests/unit/premotor/f2_config.hpp"

#include "common/config/robot_file.hpp"
#include "services/premotor/config.hpp"

namespace scarab::premotor {

PremotorConfig f2_config() { return load_config(SCARAB_SOURCE_DIR "/config/premotor/beetle.yaml"); }

robot::RobotModel beetle() {
  return config::load_robot(SCARAB_SOURCE_DIR "/config/robot/beetle.yaml");
}

}  // namespace scarab::premotor
