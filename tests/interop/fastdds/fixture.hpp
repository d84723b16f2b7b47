#pragma once

#include <gmock/gmock.h>

#include <memory>
#include <string>

#include "tests/interop/domain_claim.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/files.hpp"
#include "tests/system/stack.hpp"

namespace scarab::test {

/// Stacks on a domain of their own, with programs on Fast DDS among them.
class FastDdsTest : public testing::Test {
 protected:
  static constexpr std::chrono::seconds kTrialLimit{30};

  [[nodiscard]] Stack::Options on_this_domain() const {
    Stack::Options options;
    options.host = options.plant_host = claim_.host();
    return options;
  }

  /// Starts a program on Fast DDS as a service of the stack.
  [[nodiscard]] std::unique_ptr<ChildProcess> start_foreign(const std::string& name,
                                                            const Stack& stack,
                                                            const Arguments& more = {}) const {
    Arguments command = {program(name)};
    const auto append = [&](const Arguments& some) {
      command.insert(command.end(), some.begin(), some.end());
    };
    append(claim_.host().bus);
    append({"--expect", stack.expect(), "--run-dir", stack.directory()});
    append(more);
    return std::make_unique<ChildProcess>(command, stack.directory() / name);
  }

  [[nodiscard]] std::unique_ptr<ChildProcess> start_premotor(const Stack& stack) const {
    return start_foreign("fastdds-premotor", stack, shipped_files("premotor"));
  }

  DomainClaim claim_;
  TemporaryDirectory directory_;
};

}  // namespace scarab::test
