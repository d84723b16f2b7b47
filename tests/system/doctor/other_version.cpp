// A writer on a topic of the stack, built from another version of its IDL.
#include <other_version.h>

#include <iostream>
#include <string>

#include "common/bus/entity.hpp"

using scarab::bus::Entity;

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto domain = static_cast<dds_domainid_t>(std::stoul(argv[1]));
  const Entity participant(dds_create_participant(domain, nullptr, nullptr));
  const Entity topic(
      dds_create_topic(participant.handle(), &scarab_Operator_desc, argv[2], nullptr, nullptr));
  const Entity writer(dds_create_writer(participant.handle(), topic.handle(), nullptr, nullptr));
  if (writer.handle() < 0) return 1;
  std::cout << "there" << std::endl;
  std::cin.get();  // until the test closes its end
  return 0;
}
