#include "tools/operator/operator.hpp"

#include <chrono>
#include <iostream>
#include <map>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"

namespace scarab::operator_desk {
namespace {

const std::map<std::string, scarab_OperatorCommand> kCommands = {
    {"start", scarab_OPERATOR_START},
    {"pause", scarab_OPERATOR_PAUSE},
    {"step", scarab_OPERATOR_STEP},
    {"stop", scarab_OPERATOR_STOP},
    {"emergency-stop", scarab_OPERATOR_EMERGENCY_STOP},
    {"reset", scarab_OPERATOR_RESET}};
constexpr std::chrono::seconds kPatience{5};
constexpr std::chrono::milliseconds kPoll{5};

}  // namespace

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const auto& [name, command] : kCommands) names.push_back(name);
  return names;
}

int tell(const runtime::BusOptions& bus_options, const std::string& command,
         const std::string& reason) {
  bus::Participant participant(bus_options.participant("operator", 0));
  bus::Writer<scarab_Operator> writer(participant, bus::kOperator);
  bus::Guard guard(participant);
  runtime::Shutdown shutdown(guard);
  bus::WaitSet wait_set(participant);
  wait_set.attach(guard);
  const auto since = std::chrono::steady_clock::now();
  while (writer.matched().empty() && !shutdown.requested()) {
    if (std::chrono::steady_clock::now() - since > kPatience) {
      std::cerr << "scarab-operator: nobody listens on scarab/operator (is the stack up, on this "
                   "domain and tag?)\n";
      return runtime::kExitFailure;
    }
    wait_set.wait(kPoll);
  }
  scarab_Operator said{};
  said.header.stamp_ns = bus::now_ns();
  said.command = kCommands.at(command);
  bus::assign_truncated(said.reason, reason);
  writer.write(said);
  return runtime::kExitSuccess;
}

}  // namespace scarab::operator_desk
