#include <iostream>
#include <stdexcept>

#include "common/config/error.hpp"
#include "common/config/robot_file.hpp"
#include "services/premotor/config.hpp"
#include "tests/interop/fastdds/options.hpp"
#include "tests/interop/fastdds/premotor.hpp"

using namespace scarab;

namespace {

void serve(const fastdds::Options& options) try {
  const std::string address = options.address();
  const auto expect = fastdds::parse_expectation(options.expect);
  const auto robot = config::load_robot(options.robot);
  const auto config = premotor::load_config(options.config);
  if (options.dump_config) std::cout << premotor::dump_config(config);
  if (options.check || options.dump_config) return;
  fastdds::StopSignal stop;
  fastdds::Node node(options.domain, address, {"premotor", options.instance});
  fastdds::Premotor premotor(node, expect, premotor::PremotorController(config, robot),
                             fastdds::StateFile(options.run_dir, options.instance));
  premotor.run(stop);
} catch (const config::Error& error) {
  throw std::invalid_argument(error.what());
}

}  // namespace

int main(int argc, char** argv) {
  return fastdds::run_program(
      {"fastdds-premotor", "The premotor controller on another vendor's DDS (Fast DDS)."}, argc,
      argv, serve);
}
