#include "common/runtime/polite_threads.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <thread>

namespace scarab::runtime {
namespace {

TEST(PoliteThreads, AreThisOneAndThoseItStarts) {
  std::thread([] {  // a thread of its own: the test's is to stay as it is
    ASSERT_EQ(sched_getscheduler(0), SCHED_OTHER);
    ASSERT_TRUE(be_polite());
    EXPECT_EQ(sched_getscheduler(0), SCHED_BATCH);
    int child = SCHED_OTHER;
    std::thread([&] { child = sched_getscheduler(0); }).join();
    EXPECT_EQ(child, SCHED_BATCH);
  }).join();
  EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
}

}  // namespace
}  // namespace scarab::runtime
