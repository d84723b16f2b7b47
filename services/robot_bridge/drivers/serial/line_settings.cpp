#include "services/robot_bridge/drivers/serial/line_settings.hpp"

// The kernel's own termios2 takes any baud rate; <termios.h> knows a list only, and its structure
// of the same name forbids both in one file.
#include <asm/termbits.h>
#include <linux/serial.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <cerrno>

namespace scarab::bridge::serial {
namespace {

/// Major numbers of the slave ends of Unix 98 pseudo-terminals (Linux, admin-guide/devices.txt).
constexpr unsigned kFirstPtyMajor = 136;
constexpr unsigned kLastPtyMajor = 143;

bool is_pseudo_terminal(int fd) {
  struct stat status {};
  if (fstat(fd, &status) != 0) return false;
  const unsigned major_number = major(status.st_rdev);
  return kFirstPtyMajor <= major_number && major_number <= kLastPtyMajor;
}

}  // namespace

int set_raw(int fd, unsigned baud) noexcept {
  termios2 settings{};
  if (ioctl(fd, TCGETS2, &settings) != 0) return errno;
  settings.c_iflag = 0;
  settings.c_oflag = 0;
  settings.c_lflag = 0;
  // Without HUPCL: dropping DTR at close resets boards that take it as their reset line.
  settings.c_cflag = CS8 | CREAD | CLOCAL | BOTHER | (BOTHER << IBSHIFT);
  settings.c_ispeed = baud;
  settings.c_ospeed = baud;
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  return ioctl(fd, TCSETS2, &settings) == 0 ? 0 : errno;
}

unsigned baud_rate(int fd) noexcept {
  termios2 settings{};
  return ioctl(fd, TCGETS2, &settings) == 0 ? settings.c_ospeed : 0;
}

void ask_for_exclusive_use(int fd) noexcept {
  // A pseudo-terminal lives as long as its master: a process that is killed would leave it locked.
  if (!is_pseudo_terminal(fd)) (void)ioctl(fd, TIOCEXCL);
}

void ask_for_low_latency(int fd) noexcept {
  serial_struct settings{};
  if (ioctl(fd, TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= ASYNC_LOW_LATENCY;
  (void)ioctl(fd, TIOCSSERIAL, &settings);
}

void flush_input(int fd) noexcept { (void)ioctl(fd, TCFLSH, TCIFLUSH); }

}  // namespace scarab::bridge::serial
