#include <CLI/CLI.hpp>
#include <iostream>

#include "common/config/error.hpp"
#include "common/config/robot_file.hpp"
#include "services/premotor/config.hpp"
#include "tests/interop/fastdds/options.hpp"
#include "tests/interop/fastdds/premotor.hpp"

using namespace scarab;

namespace {

int serve(const fastdds::Options& options) {
  const std::string address = options.address();
  const auto expect = fastdds::parse_expectation(options.expect);
  const auto robot = config::load_robot(options.robot);
  const auto config = premotor::load_config(options.config);
  if (options.dump_config) std::cout << premotor::dump_config(config);
  if (options.check || options.dump_config) return 0;
  fastdds::StopSignal stop;
  fastdds::Node node(options.domain, address, {"premotor", options.instance});
  fastdds::Premotor premotor(node, expect, premotor::PremotorController(config, robot),
                             fastdds::StateFile(options.run_dir, options.instance));
  premotor.run(stop);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The premotor controller on another vendor's DDS (Fast DDS).", "fastdds-premotor"};
  fastdds::Options options;
  fastdds::add_options(app, options);
  try {
    app.parse(argc, argv);
    return serve(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const config::Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::invalid_argument& error) {
    std::cerr << "fastdds-premotor: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "fastdds-premotor: " << error.what() << '\n';
    return 1;
  }
}
