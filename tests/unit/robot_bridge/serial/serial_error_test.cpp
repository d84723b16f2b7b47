#include "services/robot_bridge/drivers/serial/serial_error.hpp"

#include <gmock/gmock.h>

#include <cerrno>

namespace scarab::bridge::serial {
namespace {

using testing::StrEq;

/// What a test that runs as root cannot provoke with a real device.
TEST(SerialErrors, PermissionNamesTheGroupThatOwnsTheDevice) {
  const SerialError error = open_error("/dev/ttyUSB0", EACCES, "uucp");
  EXPECT_EQ(error.fault(), Fault::kPermission);
  EXPECT_THAT(error.what(), StrEq("/dev/ttyUSB0: permission denied: add yourself to the group uucp "
                                  "and log in again"));
  EXPECT_THAT(open_error("/dev/ttyUSB0", EACCES, "").what(), testing::HasSubstr("group dialout"));
}

TEST(SerialErrors, ExclusiveDevicesAreInUse) {
  EXPECT_EQ(open_error("/dev/ttyUSB0", EBUSY, "").fault(), Fault::kInUse);
}

TEST(SerialErrors, WhatAdaptersAnswerOnceTheyAreGoneIsUnplugged) {
  for (const int gone : {EIO, ENODEV, ENXIO}) {
    EXPECT_EQ(use_error("/dev/ttyUSB0", gone).fault(), Fault::kUnplugged) << gone;
  }
  EXPECT_THAT(use_error("/dev/ttyUSB0", EIO).what(), StrEq("/dev/ttyUSB0: unplugged"));
}

TEST(SerialErrors, OthersKeepTheSystemsWords) {
  const SerialError error = use_error("/dev/ttyUSB0", EBADF);
  EXPECT_EQ(error.fault(), Fault::kOther);
  EXPECT_THAT(error.what(), StrEq("/dev/ttyUSB0: Bad file descriptor"));
}

}  // namespace
}  // namespace scarab::bridge::serial
