// The other process of process_test.cpp: answers each robot_state with the joint_command of the
// same tick, and says so in service_status. Runs until it is killed. Usage: bus_echo_peer TAG.
#include <iostream>

#include "common/bus/reader.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    bus::Participant participant({0, argv[1], "lo", {"premotor", 1}});
    bus::Writer<scarab_ServiceStatus> status_writer(participant, bus::kServiceStatus);
    bus::Writer<scarab_JointCommand> writer(participant, bus::kJointCommand);
    bus::Reader<scarab_RobotState> reader(participant, bus::kRobotState);
    std::string service = "premotor";
    scarab_ServiceStatus status{};
    bus::borrow(status.service, service);
    status.instance = 1;
    status_writer.write(status);
    bus::WaitSet waitset(participant);
    waitset.attach(reader);
    while (true) {
      waitset.wait(std::chrono::seconds(10));
      reader.take([&](const scarab_RobotState& state) {
        scarab_JointCommand command{};
        command.header = state.header;
        writer.write(command);
      });
    }
  } catch (const bus::Error& error) {
    std::cerr << "bus_echo_peer: " << error.what() << '\n';
    return 1;
  }
}
