// Publishes ROS 2's common messages and this folder's types, as a foreign program would: for the
// tests of tools that know none of them.
#include <wire_types.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/error.hpp"
#include "tests/integration/types/any_endpoint.hpp"
#include "tests/integration/types/sample_filler.hpp"
#include "tests/ros_idl/ros_types.hpp"

namespace scarab::test {
namespace {

constexpr std::chrono::milliseconds kPeriod{100};
constexpr int kMostRounds = 1200;  // ends by itself if nobody ends it

std::vector<const dds_topic_descriptor_t*> all_types() {
  std::vector<const dds_topic_descriptor_t*> out = ros_types();
  for (const auto* type : {&wire_Everything_desc, &wire_Single_desc, &wire_Growing_desc}) {
    out.push_back(type);
  }
  return out;
}

/// rt/JointState of sensor_msgs::msg::dds_::JointState_.
std::string topic_of(const dds_topic_descriptor_t& type) {
  const std::string name = type.m_typename;
  const std::size_t first = name.rfind(':') + 1;
  const std::size_t last = name.back() == '_' ? name.size() - 1 : name.size();
  return "rt/" + name.substr(first, last - first);
}

struct Publication {
  Publication(bus::Participant& participant, const dds_topic_descriptor_t& type,
              const bus::RawQos& qos)
      : writer(participant, topic_of(type), type, qos), sample(type) {}

  AnyWriter writer;
  FilledSample sample;
};

bus::RawQos qos_of(const dds_topic_descriptor_t& type) {
  bus::RawQos qos = kept();
  qos.xcdr2 = &type == &wire_Growing_desc;  // Cyclone writes types that may grow in no other way
  return qos;
}

volatile std::sig_atomic_t stopped = 0;

int publish(const std::string& tag) {
  std::signal(SIGTERM, [](int) { stopped = 1; });
  bus::Participant participant({0, tag, "lo", {}});
  std::vector<std::unique_ptr<Publication>> all;
  for (const dds_topic_descriptor_t* type : all_types()) {
    all.push_back(std::make_unique<Publication>(participant, *type, qos_of(*type)));
    std::printf("%s %s\n", all.back()->writer.topic().c_str(), all.back()->sample.json().c_str());
  }
  std::fflush(stdout);
  for (int round = 0; round < kMostRounds && stopped == 0; ++round) {
    for (const auto& publication : all) publication->writer.write(publication->sample.get());
    std::this_thread::sleep_for(kPeriod);
  }
  return 0;
}

}  // namespace
}  // namespace scarab::test

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: type_publisher TAG\n", stderr);
    return 2;
  }
  try {
    return scarab::test::publish(argv[1]);
  } catch (const scarab::bus::Error& error) {
    std::fprintf(stderr, "type_publisher: %s\n", error.what());
    return 1;
  }
}
