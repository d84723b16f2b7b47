#include "tests/support/test_bus.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace scarab::test {

std::string test_tag() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::to_string(::getpid()) + test->test_suite_name() + test->name();
}

bus::ParticipantOptions test_options(const std::string& service, std::uint32_t instance) {
  return {0, test_tag(), bus::kDefaultInterface, {service, instance}};
}

}  // namespace scarab::test
