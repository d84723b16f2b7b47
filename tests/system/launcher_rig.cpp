#include "tests/system/launcher_rig.hpp"

#include <stdexcept>

#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

namespace fs = std::filesystem;

Launcher::Launcher() = default;

Launcher::~Launcher() {
  if (!living().empty()) run(scarab({"down"}), kRunLimit);
}

Arguments Launcher::scarab(const Arguments& words) const {
  const Arguments places = {"--domain", std::to_string(kDomain),
                            "--bin",    fs::path(program("x")).parent_path(),
                            "--runs",   runs_};
  return Arguments{"/usr/bin/setsid", source_file("deploy/scarab")} + words + places;
}

Arguments Launcher::tool(const Arguments& words) const {
  return Arguments{"/usr/bin/env", "SCARAB_BIN=" + fs::path(program("x")).parent_path().string(),
                   "SCARAB_RUNS=" + runs_.string(), source_file("deploy/scarab")} +
         words;
}

Arguments Launcher::scarab_run(const Arguments& options) const {
  return scarab(Arguments{"run", "--no-figure", "--tag", test_tag()} + options);
}

void Launcher::up(const Arguments& options) const {
  const auto result = run(scarab(Arguments{"up", "--tag", test_tag()} + options), kRunLimit);
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
}

fs::path Launcher::run_directory() const { return fs::canonical(runs_ / "latest"); }

pid_t Launcher::pid_of(const fs::path& directory, const std::string& process) {
  const auto file = directory / "pids" / (process + ".json");
  std::string text;
  const std::string key = "\"pid\": ";
  eventually([&] { return (text = read_text(file)).find(key) != std::string::npos; });
  const auto at = text.find(key);
  if (at == std::string::npos) throw std::runtime_error(process + " does not run");
  return std::stoi(text.substr(at + key.size()));
}

std::vector<std::string> Launcher::living() const {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string line = read_text(entry.path() / "cmdline");
    if (line.find(runs_.string()) != std::string::npos) found.push_back(line);
  }
  return found;
}

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace scarab::test
