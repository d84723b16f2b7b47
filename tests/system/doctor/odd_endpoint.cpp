// A reader or writer with any QoS, for the tests of `scarab doctor`: the side that does not fit.
#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "common/bus/entity.hpp"
#include "common/bus/participant.hpp"
#include "common/bus/qos.hpp"
#include "common/bus/topic.hpp"
#include "common/runtime/program.hpp"

namespace {

using namespace scarab;

struct Options {
  bus::ParticipantOptions participant;
  bool writes = false;
  std::string topic;
  std::string type = "Operator";
  bool reliable = true;
  bool transient_local = true;
  bool exclusive = false;
  int deadline_ms = 0;  ///< 0: none
  int lease_ms = 0;
  std::string partition;
};

bus::Qos qos_of(const Options& options) {
  bus::Qos qos(dds_create_qos());
  dds_qset_reliability(
      qos.get(), options.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, 0);
  dds_qset_durability(qos.get(), options.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL
                                                         : DDS_DURABILITY_VOLATILE);
  dds_qset_ownership(qos.get(), options.exclusive ? DDS_OWNERSHIP_EXCLUSIVE : DDS_OWNERSHIP_SHARED);
  if (options.deadline_ms > 0) dds_qset_deadline(qos.get(), DDS_MSECS(options.deadline_ms));
  if (options.lease_ms > 0) {
    dds_qset_liveliness(qos.get(), DDS_LIVELINESS_AUTOMATIC, DDS_MSECS(options.lease_ms));
  }
  const char* partition = options.partition.c_str();
  if (!options.partition.empty()) dds_qset_partition(qos.get(), 1, &partition);
  if (!options.participant.self.service.empty()) bus::set_peer(*qos, options.participant.self);
  return qos;
}

int stay(const Options& options) {
  const bus::Participant participant(options.participant);
  const auto& type = options.type == "Operator" ? scarab_Operator_desc : scarab_Trial_desc;
  const bus::Entity topic(bus::check(
      dds_create_topic(participant.handle(), &type, options.topic.c_str(), nullptr, nullptr),
      options.topic));
  const bus::Qos qos = qos_of(options);
  const auto create = options.writes ? dds_create_writer : dds_create_reader;
  const bus::Entity endpoint(
      bus::check(create(participant.handle(), topic.handle(), qos.get(), nullptr), options.topic));
  std::cout << "there" << std::endl;
  std::cin.get();  // until the test closes its end
  return runtime::kExitSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A reader or writer with any QoS, until its standard input ends.", "odd_endpoint"};
  Options options;
  app.add_option("--domain", options.participant.domain);
  app.add_option("--interface", options.participant.interface);
  app.add_option("--tag", options.participant.tag);
  app.add_option("--service", options.participant.self.service);
  app.add_option("--topic", options.topic)->required();
  app.add_option("--type", options.type)->check(CLI::IsMember({"Operator", "Trial"}));
  app.add_flag("--writes", options.writes);
  app.add_flag("--reliable,!--best-effort", options.reliable);
  app.add_flag("--transient-local,!--volatile", options.transient_local);
  app.add_flag("--exclusive", options.exclusive);
  app.add_option("--deadline-ms", options.deadline_ms);
  app.add_option("--lease-ms", options.lease_ms);
  app.add_option("--partition", options.partition);
  return runtime::run_program(app, argc, argv, [&] { return stay(options); });
}
