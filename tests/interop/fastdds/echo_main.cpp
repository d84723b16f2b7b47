#include <iostream>

#include "tests/interop/fastdds/echo.hpp"
#include "tests/interop/fastdds/options.hpp"

using namespace scarab::fastdds;

int main(int argc, char** argv) {
  const Program program{"fastdds-echo",
                        "Prints every sample of the stack as JSON; takes part in it as a logger."};
  return run_program(program, argc, argv, [](const Options& options) {
    const std::string address = options.address();
    const auto expect = parse_expectation(options.expect);
    StopSignal stop;
    Node node(options.domain, address, {"logger", options.instance});
    Echo(node, expect, std::cout).run(stop);
  });
}
