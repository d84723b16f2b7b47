#pragma once

#include <gmock/gmock.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"

namespace scarab::test {

/// The launcher with the real programs, as a person calls it. Whatever a test leaves up is stopped.
class Launcher : public testing::Test {
 protected:
  static constexpr std::uint32_t kDomain = 97;
  static constexpr std::chrono::seconds kRunLimit{60};

  Launcher();
  ~Launcher() override;

  /// The command line; a session of its own, so that Ctrl-C reaches all of it and nobody else.
  [[nodiscard]] Arguments scarab(const Arguments& words) const;
  /// The command line of a tool, which takes no options of the launcher's, on this test's places.
  [[nodiscard]] Arguments tool(const Arguments& words) const;
  /// `scarab run` on a stack of its own, with the test's tag; it draws no figure.
  [[nodiscard]] Arguments scarab_run(const Arguments& options) const;
  /// `scarab up` with the test's tag. Expects success.
  void up(const Arguments& options = {}) const;

  /// The newest run directory.
  [[nodiscard]] std::filesystem::path run_directory() const;
  /// The pid file of a process of the stack in a directory, waited for; throws without one.
  [[nodiscard]] static pid_t pid_of(const std::filesystem::path& directory,
                                    const std::string& process);
  /// Command lines of processes that have to do with this test's runs.
  [[nodiscard]] std::vector<std::string> living() const;

  TemporaryDirectory directory_;
  std::filesystem::path runs_ = directory_ / "runs";
};

/// Trials whose outcome needs no physics: the time limit is success for one, failure for the other.
inline const Arguments kSuccess = {"--goal", "none", "--time-limit", "3"};
inline const Arguments kFailure = {"--goal", "travel", "--distance", "10", "--time-limit", "1"};
inline const Arguments kEndless = {"--goal", "none", "--time-limit", "36000"};

Arguments operator+(Arguments a, const Arguments& b);

}  // namespace scarab::test
