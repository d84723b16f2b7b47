#include "services/logger/core/chain_writers.hpp"

#include <array>

namespace scarab::logger {
namespace {

struct Written {
  const char* service;
  const char* topic;
};

/// The topic table of idl/README.md, seen from its writers.
constexpr std::array<Written, 8> kWritten = {{
    {"plant", "scarab/robot_state"},
    {"plant", "scarab/robot_sensors"},
    {"plant", "scarab/world_state"},
    {"robot_bridge", "scarab/robot_state"},
    {"robot_bridge", "scarab/robot_sensors"},
    {"supervisor", "scarab/behaviour"},
    {"premotor", "scarab/joint_command"},
    {"premotor", "scarab/neural_activity"},
}};

}  // namespace

std::vector<ChainWriter> chain_writers(const std::map<std::string, std::uint32_t>& expected) {
  std::vector<ChainWriter> writers;
  for (const Written& written : kWritten) {
    const auto service = expected.find(written.service);
    if (service != expected.end() && service->second > 0) {
      writers.push_back({written.topic, written.service, service->second});
    }
  }
  return writers;
}

}  // namespace scarab::logger
