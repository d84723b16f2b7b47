#include "common/runtime/polite_threads.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <thread>

namespace scarab::runtime {
namespace {

/// Of this thread; 0 where Linux does not tell it (before 6.12).
std::uint64_t slice_ns() {
  std::array<std::uint64_t, 6> attributes{};  // sched_setattr(2): the fourth is sched_runtime
  EXPECT_EQ(::syscall(SYS_sched_getattr, 0, attributes.data(), sizeof(attributes), 0), 0);
  return attributes[3];
}

TEST(PoliteThreads, AreThisOneAndThoseItStarts) {
  std::thread([] {  // a thread of its own: the test's is to stay as it is
    ASSERT_EQ(sched_getscheduler(0), SCHED_OTHER);
    ASSERT_TRUE(be_polite());
    EXPECT_EQ(sched_getscheduler(0), SCHED_BATCH);
    int child = SCHED_OTHER;
    std::thread([&] { child = sched_getscheduler(0); }).join();
    EXPECT_EQ(child, SCHED_BATCH);
  })
      .join();
  EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
}

TEST(PoliteThreads, HaveALowerPriorityButAreNotIdle) {
  const int usual = ::getpriority(PRIO_PROCESS, 0);
  std::thread([&] {
    ASSERT_TRUE(be_polite());
    EXPECT_EQ(::getpriority(PRIO_PROCESS, 0), std::max(usual, 10));
    int child = usual;
    std::thread([&] { child = ::getpriority(PRIO_PROCESS, 0); }).join();
    EXPECT_EQ(child, std::max(usual, 10));
  }).join();
}

TEST(PoliteThreads, StayAsLowAsTheUserPutThem) {
  std::thread([] {
    ASSERT_EQ(::setpriority(PRIO_PROCESS, 0, 15), 0);  // on Linux: of this thread
    ASSERT_TRUE(be_polite());
    EXPECT_EQ(::getpriority(PRIO_PROCESS, 0), 15);
  }).join();
}

TEST(PoliteThreads, HaveALongerSliceThanOthersWhereLinuxKnowsSlices) {
  const std::uint64_t usual = slice_ns();
  std::thread([&] {
    ASSERT_TRUE(be_polite());
    EXPECT_EQ(slice_ns() > usual, usual > 0) << slice_ns() << " ns, else " << usual << " ns";
    std::uint64_t child = 0;
    std::thread([&] { child = slice_ns(); }).join();
    EXPECT_EQ(child, slice_ns());
  }).join();
}

}  // namespace
}  // namespace scarab::runtime
