#include <iostream>

#include "common/runtime/program.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/session.hpp"
#include "tools/topic/topic_table.hpp"

namespace scarab::topic {

int list(const runtime::BusOptions& bus_options, const ListOptions& options) {
  Session session(bus_options);
  const auto endpoints = session.settle(options.timeout);
  if (session.interrupted()) return runtime::kExitInterrupted;
  std::cout << topic_table(endpoints, options.verbose);
  return runtime::kExitSuccess;
}

}  // namespace scarab::topic
