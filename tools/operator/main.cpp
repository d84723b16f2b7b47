#include <CLI/CLI.hpp>

#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/operator/command_line.hpp"
#include "tools/operator/operator.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"Tells the running stack what a person wants, and prints what holds then.",
               "scarab-operator"};
  runtime::BusOptions options;
  operator_desk::Order order;
  runtime::add_bus_options(app, options);
  operator_desk::add_commands(app, order);
  return runtime::run_program(app, argc, argv, [&] {
    operator_desk::check_given(order);
    const runtime::SignalBlock signals;
    return operator_desk::give(options, order);
  });
}
