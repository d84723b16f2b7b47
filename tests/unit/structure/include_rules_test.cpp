#include "tests/unit/structure/include_rules.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

/// Each rule on small made-up files: it must let the right ones pass and catch the wrong ones.
namespace scarab::structure {
namespace {

using Rule = Violations (*)(const SourceFile&);

struct Case {
  Rule rule;
  const char* path;
  const char* include;
  bool allowed;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.path << (c.allowed ? " may" : " may not") << " include " << c.include;
}

const Case kCases[] = {
    {check_pure_includes, "services/plant/core/a.cpp", "<vector>", true},
    {check_pure_includes, "services/plant/core/a.cpp", "<Eigen/Core>", true},
    {check_pure_includes, "services/plant/core/a.cpp", "<Simbody.h>", true},
    {check_pure_includes, "services/premotor/core/a.cpp", "<Simbody.h>", false},
    {check_pure_includes, "services/plant/core/a.cpp", "\"services/plant/core/b.hpp\"", true},
    {check_pure_includes, "services/plant/core/a.cpp", "\"services/plant/config.hpp\"", false},
    {check_pure_includes, "services/plant/core/a.cpp", "\"services/premotor/core/b.hpp\"", false},
    {check_pure_includes, "services/plant/core/a.cpp", "\"common/robot/joints.hpp\"", true},
    {check_pure_includes, "services/plant/core/a.cpp", "\"common/random/random.hpp\"", true},
    {check_pure_includes, "services/plant/core/a.cpp", "\"common/config/config.hpp\"", false},
    {check_pure_includes, "services/plant/core/a.cpp", "\"common/bus/topics.hpp\"", false},
    {check_pure_includes, "services/plant/core/a.cpp", "<chrono>", false},
    {check_pure_includes, "services/plant/core/a.cpp", "<thread>", false},
    {check_pure_includes, "services/plant/core/a.cpp", "<iostream>", false},
    {check_pure_includes, "services/plant/core/a.cpp", "<fmt/format.h>", true},
    {check_pure_includes, "services/plant/core/a.cpp", "<fmt/chrono.h>", false},
    {check_pure_includes, "services/plant/core/a.cpp", "<unistd.h>", false},
    {check_pure_includes, "services/plant/core/a.cpp", "<spdlog/spdlog.h>", false},
    {check_pure_includes, "services/plant/core/a.cpp", "<yaml-cpp/yaml.h>", false},
    {check_pure_includes, "services/plant/core/deep/er/a.hpp", "<mutex>", false},
    {check_pure_includes, "common/safety/a.hpp", "<mutex>", false},
    {check_pure_includes, "common/robot/a.hpp", "\"common/config/config.hpp\"", false},
    {check_pure_includes, "common/random/a.hpp", "<random>", false},
    {check_pure_includes, "services/plant/service.cpp", "<thread>", true},
    {check_pure_includes, "services/robot_bridge/drivers/x/protocol/a.cpp", "<vector>", true},
    {check_pure_includes, "services/robot_bridge/drivers/x/protocol/a.cpp", "<chrono>", false},
    {check_pure_includes, "services/robot_bridge/drivers/x/protocol/a.cpp", "<termios.h>", false},
    {check_pure_includes, "services/robot_bridge/drivers/x/protocol/a.cpp",
     "\"services/robot_bridge/drivers/x/protocol/b.hpp\"", true},
    {check_pure_includes, "services/robot_bridge/drivers/x/protocol/a.cpp",
     "\"services/robot_bridge/core/calibration.hpp\"", true},
    {check_pure_includes, "services/robot_bridge/drivers/x/protocol/a.cpp",
     "\"services/robot_bridge/drivers/x/config.hpp\"", false},
    {check_pure_includes, "services/robot_bridge/drivers/x/protocol/a.cpp",
     "\"services/robot_bridge/drivers/y/protocol/b.hpp\"", false},
    {check_pure_includes, "services/robot_bridge/drivers/x/driver.cpp", "<chrono>", true},

    {check_driver_includes, "services/robot_bridge/drivers/x/driver.cpp",
     "\"services/robot_bridge/core/driver.hpp\"", true},
    {check_driver_includes, "services/robot_bridge/drivers/x/driver.cpp",
     "\"services/robot_bridge/drivers/x/protocol/b.hpp\"", true},
    {check_driver_includes, "services/robot_bridge/drivers/x/driver.cpp",
     "\"services/robot_bridge/drivers/serial/serial_port.hpp\"", true},
    {check_driver_includes, "services/robot_bridge/drivers/x/driver.cpp",
     "\"services/robot_bridge/drivers/y/config.hpp\"", false},
    {check_driver_includes, "services/robot_bridge/drivers/serial/serial_port.cpp",
     "\"services/robot_bridge/drivers/x/config.hpp\"", false},
    {check_driver_includes, "services/robot_bridge/drivers/x/driver.cpp",
     "\"services/robot_bridge/config.hpp\"", false},
    {check_driver_includes, "services/robot_bridge/drivers/x/driver.cpp",
     "\"common/config/config.hpp\"", true},
    {check_driver_includes, "services/robot_bridge/drivers/x/driver.cpp",
     "\"common/bus/reader.hpp\"", false},
    {check_driver_includes, "services/robot_bridge/drivers/x/driver.cpp",
     "\"common/runtime/shutdown.hpp\"", false},
    {check_driver_includes, "services/robot_bridge/config.hpp",
     "\"services/robot_bridge/drivers/registry.hpp\"", true},
    {check_driver_includes, "services/robot_bridge/service.cpp",
     "\"services/robot_bridge/drivers/x/config.hpp\"", true},
    {check_driver_includes, "services/robot_bridge/service.cpp",
     "\"services/robot_bridge/drivers/x/driver.hpp\"", false},
    {check_driver_includes, "services/plant/service.cpp", "\"common/bus/reader.hpp\"", true},

    {check_dds_includes, "common/bus/reader.hpp", "<dds/dds.h>", true},
    {check_dds_includes, "common/runtime/options.cpp", "<dds/dds.h>", false},
    {check_dds_includes, "services/logger/service.cpp", "<dds/dds.h>", false},
    {check_dds_includes, "tools/topic/main.cpp", "\"dds/dds.h\"", false},
    {check_dds_includes, "common/bus/raw_cdr.cpp", "<dds/ddsi/ddsi_serdata.h>", true},
    {check_dds_includes, "common/bus/reader.hpp", "<dds/ddsi/ddsi_serdata.h>", false},

    {check_library_homes, "common/config/document.cpp", "<yaml-cpp/parser.h>", true},
    {check_library_homes, "common/config/reader.hpp", "<yaml-cpp/parser.h>", false},
    {check_library_homes, "services/plant/config.cpp", "<yaml-cpp/yaml.h>", false},
    {check_library_homes, "services/logger/service.cpp", "<zstd.h>", false},
    {check_library_homes, "services/plant/plant_body.cpp", "<Simbody.h>", false},

    {check_layers, "services/plant/service.cpp", "\"services/plant/adapter.hpp\"", true},
    {check_layers, "services/plant/service.cpp", "\"services/premotor/core/cpg.hpp\"", false},
    {check_layers, "services/plant/service.cpp", "\"tools/sim/sim.hpp\"", false},
    {check_layers, "services/plant/service.cpp", "\"common/bus/reader.hpp\"", true},
    {check_layers, "tools/sim/sim.cpp", "\"services/plant/core/simulation.hpp\"", true},
    {check_layers, "tools/sim/sim.cpp", "\"services/plant/adapter.hpp\"", true},
    {check_layers, "tools/sim/sim.cpp", "\"services/plant/service.hpp\"", false},
    {check_layers, "tools/sim/sim.cpp", "\"services/experiment/worker.hpp\"", true},
    {check_layers, "tools/sim/sim.cpp", "\"services/experiment/conductor.hpp\"", false},
    {check_layers, "tools/sim/sim.cpp", "\"tools/log/info.hpp\"", false},
    {check_layers, "tools/emulator/a.cpp", "\"services/robot_bridge/config.hpp\"", true},
    {check_layers, "tools/emulator/a.cpp", "\"services/robot_bridge/calibration_file.hpp\"", true},
    {check_layers, "tools/emulator/a.cpp", "\"services/robot_bridge/drivers/x/config.hpp\"", true},
    {check_layers, "tools/emulator/a.cpp", "\"services/robot_bridge/drivers/x/protocol/frame.hpp\"",
     true},
    {check_layers, "tools/emulator/a.cpp", "\"services/robot_bridge/drivers/x/driver.hpp\"", false},
    {check_layers, "tools/emulator/a.cpp", "\"services/robot_bridge/bridge_body.hpp\"", false},
    {check_layers, "tools/search/trial.cpp", "\"tools/sim/composition.hpp\"", true},
    {check_layers, "tools/search/trial.cpp", "\"tools/sim/sim.hpp\"", false},
    {check_layers, "common/runtime/a.cpp", "\"services/plant/adapter.hpp\"", false},
    {check_layers, "common/runtime/a.cpp", "\"common/bus/reader.hpp\"", true},
    {check_layers, "common/bus/a.cpp", "\"common/runtime/options.hpp\"", false},
    {check_layers, "common/mcap/a.cpp", "\"common/bus/reader.hpp\"", false},
    {check_layers, "common/robot/a.cpp", "\"common/config/config.hpp\"", false},
    {check_layers, "common/unheard_of/a.cpp", "\"common/bus/reader.hpp\"", false},
    {check_layers, "services/plant/service.cpp", "\"tests/unit/plant/scene.hpp\"", false},

    {check_main_includes, "services/plant/main.cpp", "\"services/plant/service.hpp\"", true},
    {check_main_includes, "services/plant/main.cpp", "\"services/plant/config.hpp\"", true},
    {check_main_includes, "services/plant/main.cpp", "\"services/plant/core/scene.hpp\"", false},
    {check_main_includes, "services/plant/main.cpp", "\"services/plant/adapter.hpp\"", false},
    {check_main_includes, "services/plant/main.cpp", "\"common/bus/reader.hpp\"", false},
    {check_main_includes, "services/plant/service.cpp", "\"common/bus/reader.hpp\"", true},
};

class IncludeRule : public testing::TestWithParam<Case> {};

TEST_P(IncludeRule, LetsPassWhatIsAllowedAndNothingElse) {
  const Case& c = GetParam();
  const SourceFile file = parse_source(c.path, std::string("\n#include ") + c.include + "\n");
  const Violations violations = c.rule(file);
  ASSERT_EQ(violations.empty(), c.allowed) << c.path << " includes " << c.include;
  if (!c.allowed) {
    EXPECT_EQ(violations[0].rfind(std::string(c.path) + ":2: ", 0), 0U) << violations[0];
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, IncludeRule, testing::ValuesIn(kCases));

}  // namespace
}  // namespace scarab::structure
