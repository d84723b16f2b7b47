#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <thread>

#include "common/runtime/state_file.hpp"
#include "tests/support/files.hpp"

namespace scarab::runtime {
namespace {

using Payload = std::array<std::int64_t, 128>;
using Counter = std::atomic<std::int64_t>;
static_assert(Counter::is_always_lock_free);

constexpr std::int64_t kCannotOpen = -2;

/// Writes records as fast as it can until it is killed; `counter` is the last that was completed.
[[noreturn]] void write_for_ever(const std::filesystem::path& path, Counter& counter) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  try {
    TypedStateFile<Payload> file(path, 1);
    Payload payload;
    for (std::int64_t tick = counter + 1;; ++tick) {
      payload.fill(tick);
      file.write({1, tick}, payload);
      counter = tick;
    }
  } catch (...) {
    counter = kCannotOpen;
  }
  ::_exit(1);
}

/// Memory that a forked child shares.
class SharedCounter {
 public:
  SharedCounter()
      : memory_(::mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS,
                       -1, 0)) {
    new (memory_) Counter(-1);
  }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  ~SharedCounter() { ::munmap(memory_, sizeof(Counter)); }
  Counter& operator*() { return *static_cast<Counter*>(memory_); }

 private:
  void* memory_;
};

TEST(StateFileKill, KilledWriterLeavesTheLastRecordOrTheOneInWork) {
  const test::TemporaryDirectory directory;
  const auto path = directory / "killed.state";
  SharedCounter counter;
  for (int kill = 0; kill < 100; ++kill) {
    const std::int64_t start = *counter;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) write_for_ever(path, *counter);
    while (*counter <= start && *counter != kCannotOpen) std::this_thread::yield();
    ::kill(child, SIGKILL);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    ASSERT_NE(*counter, kCannotOpen);

    const TypedStateFile<Payload> file(path, 1);
    Payload payload;
    const auto key = file.read(payload);
    ASSERT_TRUE(key) << "kill " << kill;
    EXPECT_GE(key->tick, *counter);  // what was completed is never lost
    EXPECT_LE(key->tick, *counter + 1);
    for (const auto value : payload) ASSERT_EQ(value, key->tick) << "kill " << kill;
    *counter = key->tick;
  }
}

}  // namespace
}  // namespace scarab::runtime
