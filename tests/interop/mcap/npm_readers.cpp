#include "tests/interop/mcap/npm_readers.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <stdexcept>

#include "tests/support/files.hpp"

namespace scarab::test {
namespace {

namespace fs = std::filesystem;

/// Held by one test at a time: npm empties the folder it installs into.
class Lock {
 public:
  explicit Lock(const fs::path& path) : file_(::open(path.c_str(), O_RDWR | O_CREAT, 0644)) {
    if (file_ < 0 || ::flock(file_, LOCK_EX) != 0) {
      throw std::runtime_error("cannot lock " + path.string());
    }
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock() { ::close(file_); }

 private:
  int file_;
};

/// Not touched if it is the same: another test may be running it.
void bring(const fs::path& from, const fs::path& to) {
  const std::string text = read_text(from);
  if (read_text(to) != text) write_text(to, text);
}

}  // namespace

NpmReaders::NpmReaders() : installed_(SCARAB_BIN_DIR "/../tests/interop-npm") {
  fs::create_directories(installed_);
  const Lock lock(installed_.parent_path() / "interop-npm.lock");
  const fs::path source = source_file("tests/interop/mcap");
  for (const auto& entry : fs::directory_iterator(source)) {
    if (entry.path().extension() == ".mjs")
      bring(entry.path(), installed_ / entry.path().filename());
  }
  for (const char* name : {"package.json", ".npmrc"}) bring(source / name, installed_ / name);
  const fs::path wanted = source / "package-lock.json";
  const fs::path stamp = installed_ / "installed";
  if (read_text(stamp) == read_text(wanted)) return;
  bring(wanted, installed_ / "package-lock.json");
  const Finished npm =
      test::run({"/usr/bin/env", "npm", "ci", "--prefix", installed_}, std::chrono::seconds(90));
  if (npm.exit_code != 0) {
    throw std::runtime_error(
        "npm ci failed; packages nodejs and npm are needed, and a registry:\n" + npm.out + npm.err);
  }
  write_text(stamp, read_text(wanted));
}

Finished NpmReaders::run(const std::string& name, const Arguments& arguments) const {
  Arguments command = {"/usr/bin/env", "node", installed_ / name};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return test::run(command, std::chrono::seconds(60));
}

}  // namespace scarab::test
