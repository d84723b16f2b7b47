#include <CLI/CLI.hpp>
#include <iostream>

#include "tests/interop/fastdds/echo.hpp"
#include "tests/interop/fastdds/options.hpp"

using namespace scarab::fastdds;

int main(int argc, char** argv) {
  CLI::App app{"Prints every sample of the stack as JSON; takes part in it as a logger.",
               "fastdds-echo"};
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
    const std::string address = options.address();
    const auto expect = parse_expectation(options.expect);
    StopSignal stop;
    Node node(options.domain, address, {"logger", options.instance});
    Echo(node, expect, std::cout).run(stop);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::invalid_argument& error) {
    std::cerr << "fastdds-echo: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "fastdds-echo: " << error.what() << '\n';
    return 1;
  }
}
