#include "services/robot_bridge/drivers/serial/serial_port.hpp"

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <utility>

#include "services/robot_bridge/drivers/serial/line_settings.hpp"

namespace scarab::bridge::serial {
namespace {

std::string group_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return {};
  const group* owner = getgrgid(status.st_gid);
  return owner == nullptr ? std::string() : owner->gr_name;
}

/// Time left until the deadline; none once it has passed.
timespec left_until(Deadline deadline) {
  constexpr std::int64_t kNsPerS = 1'000'000'000;
  const std::int64_t left_ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(deadline - Clock::now()).count();
  if (left_ns <= 0) return {0, 0};
  return {static_cast<time_t>(left_ns / kNsPerS), static_cast<long>(left_ns % kNsPerS)};
}

/// 0 or an errno.
int lock_and_set_up(int fd, unsigned baud) {
  // The lock that also holds against root and on pseudo-terminals; it goes with the process.
  if (flock(fd, LOCK_EX | LOCK_NB) != 0) return errno;
  const int error = set_raw(fd, baud);
  if (error != 0) return error;
  if (!is_near(baud_rate(fd), baud)) return EINVAL;
  ask_for_exclusive_use(fd);
  ask_for_low_latency(fd);
  flush_input(fd);
  return 0;
}

}  // namespace

SerialPort::SerialPort(const std::string& path, unsigned baud) : path_(path) {
  fd_ = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd_ < 0) throw open_error(path, errno, errno == EACCES ? group_of(path) : "");
  const int error = lock_and_set_up(fd_, baud);
  if (error == 0) return;
  close(std::exchange(fd_, -1));
  if (error == EINVAL) {
    throw SerialError(Fault::kSettings,
                      path + ": takes no rate of " + std::to_string(baud) + " baud");
  }
  throw open_error(path, error, "");
}

SerialPort::~SerialPort() {
  if (fd_ >= 0) close(fd_);
}

SerialPort::SerialPort(SerialPort&& other) noexcept
    : path_(std::move(other.path_)), fd_(std::exchange(other.fd_, -1)) {}

SerialPort& SerialPort::operator=(SerialPort&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fd_, other.fd_);
  return *this;
}

bool SerialPort::wait_for(short events, Deadline deadline) const {
  for (;;) {
    pollfd request{fd_, events, 0};
    const timespec left = left_until(deadline);
    const int ready = ppoll(&request, 1, &left, nullptr);
    if (ready == 0) return false;
    if (ready > 0 && (request.revents & events) != 0) return true;
    if (ready > 0) throw unplugged(path_);
    if (errno != EINTR) throw use_error(path_, errno);
  }
}

void SerialPort::write(const std::uint8_t* data, std::size_t size, Deadline deadline) {
  std::size_t written = 0;
  while (written < size) {
    const ssize_t step = ::write(fd_, data + written, size - written);
    if (step > 0) {
      written += static_cast<std::size_t>(step);
    } else if (step < 0 && errno != EAGAIN && errno != EINTR) {
      throw use_error(path_, errno);
    } else if (!wait_for(POLLOUT, deadline)) {
      throw SerialError(Fault::kTimedOut, path_ + ": took " + std::to_string(written) + " of " +
                                              std::to_string(size) + " bytes in time");
    }
  }
}

std::size_t SerialPort::read_some(std::uint8_t* data, std::size_t capacity, Deadline deadline) {
  while (wait_for(POLLIN, deadline)) {
    const ssize_t size = ::read(fd_, data, capacity);
    if (size > 0) return static_cast<std::size_t>(size);
    if (size == 0) throw unplugged(path_);
    if (errno != EAGAIN && errno != EINTR) throw use_error(path_, errno);
  }
  return 0;
}

void SerialPort::discard_input() noexcept { flush_input(fd_); }

unsigned SerialPort::baud() const noexcept { return baud_rate(fd_); }

}  // namespace scarab::bridge::serial
