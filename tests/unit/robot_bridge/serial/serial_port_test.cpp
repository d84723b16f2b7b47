#include "services/robot_bridge/drivers/serial/serial_port.hpp"

#include <gmock/gmock.h>
#include <poll.h>

#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include "services/robot_bridge/drivers/serial/line_settings.hpp"
#include "tests/support/files.hpp"
#include "tests/unit/robot_bridge/serial/pseudo_terminal.hpp"

namespace scarab::bridge::serial {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using testing::IsEmpty;
using testing::StrEq;

constexpr unsigned kBaud = 57600;

Deadline in(Clock::duration time) { return Clock::now() + time; }

/// The fault of what `action` throws; none if it throws nothing of the kind.
template <class Action>
std::optional<Fault> fault_of(Action action) {
  try {
    action();
  } catch (const SerialError& error) {
    return error.fault();
  }
  return std::nullopt;
}

Bytes every_byte() {
  Bytes bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

/// `size` bytes as they come, or those of the first 5 s.
Bytes read_all(SerialPort& port, std::size_t size) {
  Bytes bytes;
  std::array<std::uint8_t, 64> part{};
  const Deadline deadline = in(5s);
  while (bytes.size() < size) {
    const std::size_t step = port.read_some(part, deadline);
    if (step == 0) break;
    bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(step));
  }
  return bytes;
}

TEST(SerialPort, CarriesEveryByteUnchangedBothWays) {
  test::PseudoTerminal device;
  SerialPort port(device.path(), kBaud);
  port.write(every_byte(), in(1s));
  EXPECT_EQ(device.read(256), every_byte());
  device.write(every_byte());
  EXPECT_EQ(read_all(port, 256), every_byte());
}

TEST(SerialPort, TakesAnyBaudRate) {
  for (const unsigned baud : {57600U, 1'000'000U, 3'000'000U, 4'500'000U, 250'000U, 31'250U}) {
    const test::PseudoTerminal device;
    const SerialPort port(device.path(), baud);
    EXPECT_EQ(port.baud(), baud);
  }
}

TEST(LineSettings, ARateIsTakenAsItIsMadeOrNearly) {
  static_assert(is_near(57600, 57600) && is_near(57142, 57600) && is_near(1'022'000, 1'000'000));
  static_assert(!is_near(9600, 1'000'000) && !is_near(921'600, 1'000'000) && !is_near(0, 57600));
}

TEST(SerialPort, ReadEndsAtItsDeadline) {
  const test::PseudoTerminal device;
  SerialPort port(device.path(), kBaud);
  std::array<std::uint8_t, 8> buffer{};
  const auto begin = Clock::now();
  EXPECT_EQ(port.read_some(buffer, in(20ms)), 0U);
  EXPECT_GE(Clock::now() - begin, 20ms);
  EXPECT_LT(Clock::now() - begin, 2s);
  EXPECT_EQ(port.read_some(buffer, in(-1s)), 0U) << "a deadline in the past only looks";
}

TEST(SerialPort, WriteEndsAtItsDeadlineWhenNobodyReads) {
  const test::PseudoTerminal device;
  SerialPort port(device.path(), kBaud);
  const Bytes much(1 << 20);
  const auto begin = Clock::now();
  EXPECT_EQ(fault_of([&] { port.write(much, in(30ms)); }), Fault::kTimedOut);
  EXPECT_LT(Clock::now() - begin, 2s);
}

TEST(SerialPort, ThrowsAwayWhatArrivedBeforeAndWhenAsked) {
  test::PseudoTerminal device;
  device.write({1, 2, 3});
  SerialPort port(device.path(), kBaud);
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_EQ(port.read_some(buffer, in(0s)), 0U) << "from before it was opened";
  device.write({4, 5});
  ASSERT_EQ(read_all(port, 2), (Bytes{4, 5}));
  device.write({6});
  pollfd arrived{port.fd(), POLLIN, 0};
  ASSERT_EQ(poll(&arrived, 1, 5000), 1);
  port.discard_input();
  EXPECT_EQ(port.read_some(buffer, in(0s)), 0U);
}

TEST(SerialPort, KnowsThatTheDeviceIsGone) {
  test::PseudoTerminal device;
  SerialPort port(device.path(), kBaud);
  device.unplug();
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_EQ(fault_of([&] { (void)port.read_some(buffer, in(1s)); }), Fault::kUnplugged);
  EXPECT_EQ(fault_of([&] { port.write(Bytes{1}, in(1s)); }), Fault::kUnplugged);
}

TEST(SerialPort, IsForOneProcessAtATime) {
  const test::PseudoTerminal device;
  {
    const SerialPort first(device.path(), kBaud);
    EXPECT_EQ(fault_of([&] { const SerialPort second(device.path(), kBaud); }), Fault::kInUse);
  }
  EXPECT_EQ(fault_of([&] { const SerialPort again(device.path(), kBaud); }), std::nullopt);
}

TEST(SerialPort, SaysWhatIsNotThere) {
  try {
    const SerialPort port("/dev/ttyNotThere0", kBaud);
    FAIL() << "opened";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), StrEq("/dev/ttyNotThere0: no such device"));
  }
}

TEST(SerialPort, RefusesWhatIsNoSerialPort) {
  const test::TemporaryDirectory directory;
  test::write_text(directory / "file", "text");
  for (const std::string& path :
       {(directory / "file").string(), directory.path().string(), std::string("/dev/null")}) {
    EXPECT_EQ(fault_of([&] { const SerialPort port(path, kBaud); }), Fault::kNotSerial) << path;
  }
}

TEST(SerialPort, MovesWithItsDevice) {
  test::PseudoTerminal device;
  SerialPort first(device.path(), kBaud);
  SerialPort second(std::move(first));
  second.write(Bytes{42}, in(1s));
  EXPECT_EQ(device.read(1), (Bytes{42}));
  EXPECT_EQ(second.path(), device.path());
}

}  // namespace
}  // namespace scarab::bridge::serial
