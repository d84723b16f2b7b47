#include "services/robot_bridge/crash_stop.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <string>
#include <utility>

namespace scarab::bridge {
namespace {

constexpr std::array<int, 5> kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// What the handler writes, and where. Global, since a signal handler is given nothing else.
struct Armed {
  std::atomic<bool> ready{false};
  int fd = -1;
  std::size_t size = 0;
  std::array<std::uint8_t, kCrashFrameMost> bytes{};
};
static_assert(std::atomic<bool>::is_always_lock_free);
Armed armed;

/// A stack of the handler's own: the one it interrupts may be the one that overflowed. For the
/// thread that installs it, which is the one that works.
alignas(16) std::array<std::byte, 16384> handler_stack;

void write_crash_frame() {
  if (!armed.ready.exchange(false)) return;
  std::size_t written = 0;
  for (int attempt = 0; attempt < 100 && written < armed.size; ++attempt) {
    const ssize_t count = ::write(armed.fd, armed.bytes.data() + written, armed.size - written);
    if (count > 0) written += static_cast<std::size_t>(count);
  }
}

/// The signal's own action is back in place (SA_RESETHAND): raised again, it ends the process as
/// soon as this returns.
void handle(int signal) {
  write_crash_frame();
  ::raise(signal);
}

void disarm() noexcept { armed.ready.store(false); }

void arm(const CrashFrame& frame) {
  if (frame.bytes.size() > armed.bytes.size()) {
    throw DeviceError("its crash frame has " + std::to_string(frame.bytes.size()) +
                      " bytes, there is room for " + std::to_string(armed.bytes.size()));
  }
  disarm();
  armed.fd = frame.fd;
  armed.size = frame.bytes.size();
  std::copy(frame.bytes.begin(), frame.bytes.end(), armed.bytes.begin());
  armed.ready.store(true);
}

class CrashStoppedDriver : public Driver {
 public:
  explicit CrashStoppedDriver(std::unique_ptr<Driver> driver) : driver_(std::move(driver)) {}
  ~CrashStoppedDriver() override { disarm(); }

  void open() override { driver_->open(); }
  void close() noexcept override {
    disarm();  // before: the number of a closed file may be given to another
    driver_->close();
  }
  Readings read() override { return driver_->read(); }
  void activate(const robot::JointVector& hold_rad) override {
    if (const auto frame = driver_->crash_frame()) arm(*frame);
    driver_->activate(hold_rad);
  }
  void write(const robot::JointVector& target_rad) override { driver_->write(target_rad); }
  bool hold() noexcept override { return driver_->hold(); }
  bool release() noexcept override {
    const bool released = driver_->release();
    if (released) disarm();
    return released;
  }
  [[nodiscard]] Capabilities capabilities() const override { return driver_->capabilities(); }
  [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> counters() const override {
    return driver_->counters();
  }
  [[nodiscard]] std::optional<CrashFrame> crash_frame() const override {
    return driver_->crash_frame();
  }

 private:
  std::unique_ptr<Driver> driver_;
};

}  // namespace

void install_crash_handler() {
  stack_t stack{};
  stack.ss_sp = handler_stack.data();
  stack.ss_size = handler_stack.size();
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
}

std::unique_ptr<Driver> with_crash_stop(std::unique_ptr<Driver> driver) {
  return std::make_unique<CrashStoppedDriver>(std::move(driver));
}

}  // namespace scarab::bridge
