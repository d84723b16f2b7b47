#include "services/robot_bridge/crash_stop.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "tests/unit/robot_bridge/core/noting_driver.hpp"

/// Each death in a child process; the pipe stands for the line to the device.
namespace scarab::bridge {
namespace {

constexpr char kFrame[] = "all motors off";

/// A device that can switch its motors off with one frame.
class SwitchedDriver : public NotingDriver {
 public:
  explicit SwitchedDriver(int fd) : fd_(fd) {}
  [[nodiscard]] std::optional<CrashFrame> crash_frame() const override {
    return CrashFrame{fd_, {kFrame, kFrame + sizeof kFrame - 1}};
  }

 private:
  int fd_;
};

/// How the child ended, and what reached the line.
struct Death {
  int signal = 0;
  std::string line;
};

template <class Device = SwitchedDriver, class Life>
Death after(const Life& life) {
  std::array<int, 2> line{};
  EXPECT_EQ(::pipe(line.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(line[0]);
    ::close(STDERR_FILENO);  // what the C++ library has to say of it
    install_crash_handler();
    life(with_crash_stop(std::make_unique<Device>(line[1])));
    ::_exit(0);
  }
  ::close(line[1]);
  Death death;
  std::array<char, 256> bytes{};
  for (ssize_t count = 1; count > 0;) {
    count = ::read(line[0], bytes.data(), bytes.size());
    if (count > 0) death.line.append(bytes.data(), static_cast<std::size_t>(count));
  }
  ::close(line[0]);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  death.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return death;
}

class EachSignal : public testing::TestWithParam<int> {};

TEST_P(EachSignal, SwitchesTheMotorsOffAndKillsAsItWould) {
  const int signal = GetParam();
  const Death death = after([signal](std::unique_ptr<Driver> driver) {
    driver->open();
    driver->activate({});
    ::raise(signal);
  });
  EXPECT_EQ(death.signal, signal);
  EXPECT_EQ(death.line, kFrame) << "once";
}

INSTANTIATE_TEST_SUITE_P(CrashStop, EachSignal,
                         testing::Values(SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT));

TEST(CrashStop, CoversAnExceptionThatNobodyCatches) {
  const Death death = after([](std::unique_ptr<Driver> driver) {
    driver->open();
    driver->activate({});
    std::terminate();
  });
  EXPECT_EQ(death.signal, SIGABRT);
  EXPECT_EQ(death.line, kFrame);
}

/// Dies once its first motors are on.
class HalfOnDriver : public SwitchedDriver {
 public:
  using SwitchedDriver::SwitchedDriver;
  void activate(const robot::JointVector&) override { std::abort(); }
};

TEST(CrashStop, CoversTheSwitchingOnItself) {
  const Death death = after<HalfOnDriver>([](std::unique_ptr<Driver> driver) {
    driver->open();
    driver->activate({});
  });
  EXPECT_EQ(death.signal, SIGABRT);
  EXPECT_EQ(death.line, kFrame);
}

TEST(CrashStop, WritesNothingBeforeMotorsAreOn) {
  const Death death = after([](std::unique_ptr<Driver> driver) {
    driver->open();
    std::abort();
  });
  EXPECT_EQ(death.signal, SIGABRT);
  EXPECT_EQ(death.line, "");
}

TEST(CrashStop, WritesNothingOnceMotorsAreOffOrTheLineIsClosed) {
  for (const bool by_closing : {true, false}) {
    const Death death = after([by_closing](std::unique_ptr<Driver> driver) {
      driver->open();
      driver->activate({});
      if (by_closing) {
        driver->close();
      } else {
        driver->release();
      }
      std::abort();
    });
    EXPECT_EQ(death.signal, SIGABRT);
    EXPECT_EQ(death.line, "");
  }
}

TEST(CrashStop, StaysReadyThroughAHold) {
  const Death death = after([](std::unique_ptr<Driver> driver) {
    driver->open();
    driver->activate({});
    driver->hold();
    std::abort();
  });
  EXPECT_EQ(death.line, kFrame) << "a robot that holds has its motors on";
}

/// A frame that the handler has no room for.
class VerboseDriver : public NotingDriver {
 public:
  [[nodiscard]] std::optional<CrashFrame> crash_frame() const override {
    return CrashFrame{1, std::vector<std::uint8_t>(kCrashFrameMost + 1)};
  }
};

TEST(CrashStop, RefusesAFrameItHasNoRoomFor) {
  const auto driver = with_crash_stop(std::make_unique<VerboseDriver>());
  driver->open();
  EXPECT_THROW(driver->activate({}), DeviceError);
}

TEST(CrashStop, PassesEverythingOn) {
  auto inner = std::make_unique<NotingDriver>();
  NotingDriver& noted = *inner;
  const auto driver = with_crash_stop(std::move(inner));
  driver->open();
  (void)driver->read();
  driver->activate({});
  driver->write({});
  EXPECT_TRUE(driver->hold());
  EXPECT_TRUE(driver->release());
  driver->close();
  EXPECT_EQ(noted.calls, (std::vector<std::string>{"open", "read", "activate", "write", "hold",
                                                   "release", "close"}));
  EXPECT_TRUE(driver->capabilities().torque_switch);
}

}  // namespace
}  // namespace scarab::bridge
