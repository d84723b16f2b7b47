#include "common/runtime/program.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "common/config/error.hpp"
#include "common/runtime/usage_error.hpp"

namespace scarab::runtime {

int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  try {
    app.parse(argc, argv);
    return body();
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    std::cerr << app.get_name() << ": " << usage_error(app, error) << " (see --help)\n";
    return kExitBadUsage;
  } catch (const config::Error& error) {
    std::cerr << error.what() << '\n';
    return kExitBadUsage;
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
    return kExitFailure;
  }
}

}  // namespace scarab::runtime
