#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "tests/support/programs.hpp"

namespace scarab::test {

/// A stack of real services, up as long as the object, on the running test's tag.
class Stack {
 public:
  struct Options {
    std::map<std::string, unsigned> replicas = {};  ///< processes of a service; else 1
    bool witness = false;                           ///< a Witness of the test takes part
    std::string robot = "beetle";
    bool real_time = false;  ///< the plant's pace: by the wall clock, else lockstep
    Host plant_host = {};
    Host host = {};                     ///< of all others, the experiment too
    std::set<std::string> others = {};  ///< services expected, but started by somebody else
  };

  /// Starts all services; `directory` is made and becomes their run directory.
  explicit Stack(const std::filesystem::path& directory, const Options& options);
  explicit Stack(const std::filesystem::path& directory) : Stack(directory, Options{}) {}

  /// Kills what lives: how it ends is of no interest to a test that has not called stop().
  ~Stack();
  Stack(const Stack&) = delete;
  Stack& operator=(const Stack&) = delete;

  ChildProcess& service(const std::string& name, std::uint32_t instance = 0);
  /// SIGKILL.
  void kill(const std::string& name, std::uint32_t instance = 0);
  /// Starts one anew that was killed.
  void restart(const std::string& name, std::uint32_t instance = 0);
  /// Starts the experiment service with these options and this stdin.
  [[nodiscard]] ChildProcess conduct(const Arguments& options,
                                     const std::filesystem::path& input = "/dev/null") const;
  /// Ends all services that live, the logger last; true if all ended with exit code 0.
  bool stop();

  /// The closed log, once the stack is stopped.
  [[nodiscard]] std::filesystem::path log() const { return directory_ / "trial.mcap"; }
  [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }
  /// What each process is told of the stack: its option --expect.
  [[nodiscard]] const std::string& expect() const { return expect_; }
  /// What all services have said on stderr.
  [[nodiscard]] std::string errors() const;

 private:
  using Key = std::pair<std::string, std::uint32_t>;
  [[nodiscard]] ChildProcess launch(const Key& key) const;

  std::filesystem::path directory_;
  Options options_;
  std::string expect_;
  std::map<Key, ChildProcess> services_;
};

/// The trial of the main job: two changes of mode, over the paper's highest obstacle.
Arguments main_trial();

/// The arguments of scarab-sim with the files shipped for a robot: `trial` recorded in `output`.
Arguments simulate(const std::filesystem::path& output, const Arguments& trial = main_trial(),
                   const std::string& robot = "beetle");

}  // namespace scarab::test
