#include <gmock/gmock.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <set>
#include <sstream>

#include "tests/support/eventually.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/test_bus.hpp"
#include "tests/system/stack.hpp"

namespace scarab::test {
namespace {

using Table = std::map<std::string, std::set<int>>;

constexpr std::chrono::seconds kLimit{20};
constexpr const char* kCtrlC = "\x03";

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::string rest = line.size() > 3 ? line.substr(2, line.size() - 4) : "";
  for (auto at = rest.find(" | "); at != std::string::npos; at = rest.find(" | ")) {
    cells.push_back(rest.substr(0, at));
    rest = rest.substr(at + 3);
  }
  cells.push_back(rest);
  return cells;
}

/// Exit codes of the compiled programs as docs/commands.md lists them; a dash is none. Those that
/// only scarab-topic has are seen to in tests/integration/topic.
Table documented() {
  const std::vector<int> codes = {0, 1, 2, 130};
  Table table;
  std::istringstream page(read_text(source_file("docs/commands.md")));
  for (std::string line; std::getline(page, line);) {
    const auto cells = cells_of(line);
    if (cells.size() != 5 || cells[0].rfind("`scarab-", 0) != 0) continue;
    auto& row = table[cells[0].substr(1, cells[0].size() - 2)];
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (cells[i + 1] != "-") row.insert(codes[i]);
    }
  }
  return table;
}

/// The process blocks the signal, to wait for it, or catches it.
bool listens(pid_t process, int number) {
  const auto status = read_text("/proc/" + std::to_string(process) + "/status");
  const auto has = [&](const std::string& mask) {
    const auto at = status.find(mask + ":\t");
    if (at == std::string::npos) return false;
    const auto bits = std::stoull(status.substr(at + mask.size() + 2, 16), nullptr, 16);
    return (bits >> (number - 1) & 1U) != 0;
  };
  return has("SigBlk") || has("SigCgt");
}

/// Makes every program end in every way it can.
class ExitCodes : public testing::Test {
 protected:
  void expect(int code, const std::string& name, const Arguments& words) {
    Arguments command = {program(name)};
    command.insert(command.end(), words.begin(), words.end());
    const auto result = run(command, kLimit);
    EXPECT_EQ(result.exit_code, code) << name << ": " << result.out << result.err;
    if (code == 2) {
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << name << result.err;
    }
    seen_[name].insert(code);
  }
  /// Ends it by a signal once it listens for that.
  void expect_at_signal(int code, const std::string& name, const Arguments& words, int number) {
    Arguments command = {program(name)};
    command.insert(command.end(), words.begin(), words.end());
    ChildProcess child(command, directory_ / name);
    EXPECT_TRUE(eventually([&] { return listens(child.pid(), number); })) << child.output();
    child.signal(number);
    EXPECT_EQ(child.wait(kLimit), code) << name << child.output();
    seen_[name].insert(code);
  }
  /// Types `keys` into a terminal of its own, once that has shown `prompt`.
  void expect_in_terminal(int code, const std::string& name, const Arguments& words,
                          const std::string& prompt, const std::string& keys);
  [[nodiscard]] Arguments simulation(const Arguments& trial) const {
    Arguments words = {"--robot",      source_file("config/robot/beetle.yaml"),
                       "--plant",      source_file("config/plant/beetle.yaml"),
                       "--premotor",   source_file("config/premotor/beetle.yaml"),
                       "--supervisor", source_file("config/supervisor/beetle.yaml"),
                       "--quiet"};
    words.insert(words.end(), trial.begin(), trial.end());
    return words;
  }
  void services();
  void robot();
  void tools();
  void trials();
  void search();
  void drive();
  void calibrate();

  TemporaryDirectory directory_;
  const Arguments bus_ = {"--tag", test_tag()};
  Table seen_;
};

void ExitCodes::expect_in_terminal(int code, const std::string& name, const Arguments& words,
                                   const std::string& prompt, const std::string& keys) {
  Arguments command = {program(name)};
  command.insert(command.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& word : command) argv.push_back(word.data());
  argv.push_back(nullptr);
  int terminal = -1;
  winsize size{};
  size.ws_row = 24;
  size.ws_col = 80;
  const pid_t pid = ::forkpty(&terminal, nullptr, nullptr, &size);
  if (pid == 0) {
    ::setenv("TERM", "xterm", 1);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  std::string shown;
  char next = 0;
  do {
    ASSERT_EQ(::read(terminal, &next, 1), 1) << name << ": " << shown;
    shown += next;
  } while (shown.find(prompt) == std::string::npos);
  EXPECT_EQ(::write(terminal, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  while (::read(terminal, &next, 1) == 1) shown += next;
  int status = 0;
  ::waitpid(pid, &status, 0);
  ::close(terminal);
  EXPECT_EQ(WEXITSTATUS(status), code) << name << ": " << shown;
  seen_[name].insert(WEXITSTATUS(status));
}

void ExitCodes::services() {
  for (const std::string name : {"plant", "supervisor", "premotor"}) {
    auto words = shipped_files(name);
    words.insert(words.end(), bus_.begin(), bus_.end());
    expect_at_signal(0, "scarab-" + name, words, SIGTERM);
    words.insert(words.end(), {"--interface", "no-such"});
    expect(1, "scarab-" + name, words);
    expect(2, "scarab-" + name, {"--no-such-option"});
  }
  robot();
  const std::string log = directory_ / "trial.mcap";
  expect_at_signal(0, "scarab-logger", {"--output", log, "--tag", test_tag()}, SIGTERM);
  expect(1, "scarab-logger", {"--output", "/proc/no/trial.mcap"});
  expect(2, "scarab-logger", {"--no-such-option"});
}

/// The bridge waits for a port that is not there; the emulator makes one.
void ExitCodes::robot() {
  for (const std::string name : {"robot_bridge", "emulator"}) {
    auto words = shipped_files(name);
    words.insert(words.end(), bus_.begin(), bus_.end());
    words.insert(words.end(), {"--device", directory_ / name});
    expect_at_signal(0, program_of(name), words, SIGTERM);
    words.insert(words.end(), {"--interface", "no-such"});
    expect(1, program_of(name), words);
    expect(2, program_of(name), {"--no-such-option"});
  }
  expect(1, "scarab-emulator", {"tell", directory_.path(), "clear"});
  expect(2, "scarab-emulator", {"tell", directory_.path(), "sulk"});
}

void ExitCodes::tools() {
  const std::string log = directory_ / "trial.mcap";  // the logger's, from before
  expect(0, "scarab-log", {"info", log});
  expect(1, "scarab-log", {"info", source_file("README.md")});
  expect(2, "scarab-log", {"info", directory_ / "none"});
  expect_at_signal(130, "scarab-log",
                   {"replay", log, "--wait", "1", "--timeout", "60", "--tag", test_tag()}, SIGINT);
  const std::string file = source_file("config/plant/beetle.yaml");
  expect(0, "scarab-config", {"diff", file, file});
  expect(1, "scarab-config", {"diff", file, source_file("config/plant/beetle-noisy.yaml")});
  write_text(directory_ / "bad.yaml", "no_such_key: 1\n");
  expect(2, "scarab-config", {"check", "--kind", "plant", directory_ / "bad.yaml"});
  expect(0, "scarab-topic", {"list", "--tag", test_tag()});
  expect(1, "scarab-topic", {"list", "--interface", "no-such"});
  expect(2, "scarab-topic", {"--no-such-option"});
  expect_at_signal(130, "scarab-topic", {"hz", "scarab/trial", "--tag", test_tag()}, SIGINT);
  expect(1, "scarab-operator", {"pause", "--tag", test_tag()});
  expect(2, "scarab-operator", {"--no-such-option"});
  expect_at_signal(130, "scarab-operator", {"pause", "--tag", test_tag()}, SIGINT);
  expect(0, "scarab-doctor", {"--timeout", "0.2", "--tag", test_tag()});
  expect(1, "scarab-doctor", {"--interface", "no-such"});
  expect(2, "scarab-doctor", {"--no-such-option"});
  expect_at_signal(130, "scarab-doctor", {"--timeout", "60", "--tag", test_tag()}, SIGINT);
  expect(1, "scarab-status", bus_);
  expect(2, "scarab-status", {"--wait", "nonsense"});
  expect_at_signal(130, "scarab-status",
                   {"--wait", "plant=1", "--timeout", "60", "--tag", test_tag()}, SIGINT);
}

void ExitCodes::trials() {
  expect(0, "scarab-sim", simulation({"--goal", "none", "--time-limit", "1"}));
  expect(1, "scarab-sim",
         simulation({"--goal", "travel", "--distance", "10", "--time-limit", "1"}));
  expect(2, "scarab-sim", simulation({"--goal", "home"}));
  expect_at_signal(130, "scarab-sim", simulation({"--goal", "none", "--time-limit", "36000"}),
                   SIGINT);
  const Arguments alone = {"--expect", "plant=1", "--tag", test_tag()};
  expect(1, "scarab-experiment",
         {"--expect", "plant=1", "--ready-limit", "1", "--tag", test_tag()});
  expect(2, "scarab-experiment", {"--goal", "home"});
  expect_at_signal(130, "scarab-experiment", alone, SIGINT);
}

void ExitCodes::search() {
  const std::string file = source_file("config/search/example.yaml");
  expect(0, "scarab-search", {"check", file});
  expect(1, "scarab-search", {"run", file, "--out", "/proc/no"});
  expect(2, "scarab-search", {"run", directory_ / "bad.yaml", "--out", directory_ / "search"});
  expect_at_signal(130, "scarab-search", {"run", file, "--out", directory_ / "search"}, SIGINT);
}

/// With a terminal, and without.
void ExitCodes::drive() {
  const Arguments words = {"--tag", test_tag()};
  expect_in_terminal(0, "scarab-drive", words, "", "q");  // it draws, so it listens
  expect_in_terminal(130, "scarab-drive", words, "", kCtrlC);
  expect(2, "scarab-drive", {});
}

/// Of a robot without a device, and of one that is not there.
void ExitCodes::calibrate() {
  const auto words = [&](const std::string& driver, const Arguments& more) {
    const std::string name = "beetle-" + driver + ".yaml";
    const std::string own = directory_ / name;
    write_text(own, read_text(source_file("config/calibration/" + name)));
    Arguments all = {"--robot",  source_file("config/robot/beetle.yaml"),
                     "--config", source_file("config/robot_bridge/" + name),
                     "--output", own};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect(0, "scarab-calibrate", words("loopback", {"--pose", "start", "--yes", "--again"}));
  expect(1, "scarab-calibrate", words("dynamixel", {"--yes", "--device", directory_ / "none"}));
  expect(2, "scarab-calibrate", {"--no-such-option"});
  expect_in_terminal(130, "scarab-calibrate", words("loopback", {"--again"}), "Enter: ", kCtrlC);
}

TEST_F(ExitCodes, AreThoseOfTheDocumentation) {
  services();
  tools();
  trials();
  search();
  drive();
  calibrate();
  {
    ChildProcess plant = start({"plant", "plant=1", directory_.path(), 0, {}});
    expect(0, "scarab-status", {"--wait", "plant=1", "--timeout", "10", "--tag", test_tag()});
    expect(0, "scarab-operator", {"estop", "--tag", test_tag()});
  }
  Stack stack(directory_ / "stack");
  auto experiment = stack.conduct({"--goal", "none", "--time-limit", "1"});
  EXPECT_EQ(experiment.wait(kLimit), 0) << experiment.output();
  seen_["scarab-experiment"].insert(0);
  EXPECT_EQ(seen_, documented());
}

}  // namespace
}  // namespace scarab::test
