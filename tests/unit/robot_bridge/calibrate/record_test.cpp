#include "services/robot_bridge/calibrate/record.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "common/config/error.hpp"
#include "services/robot_bridge/calibration_file.hpp"
#include "tests/support/files.hpp"

namespace scarab::bridge::calibrate {
namespace {

class CalibrationRecord : public testing::Test {
 protected:
  [[nodiscard]] std::ptrdiff_t files() const {
    const std::filesystem::directory_iterator begin(directory_.path());
    return std::distance(begin, std::filesystem::directory_iterator());
  }

  test::TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_ / "new.yaml";
};

TEST_F(CalibrationRecord, IsOnDiskAfterEachJoint) {
  Record record(path_);
  EXPECT_FALSE(std::filesystem::exists(path_)) << "nothing is known yet";
  record.set(3, {0.1, -1, -1, 1}, "a note");
  EXPECT_EQ(load_calibration(path_).joints[3]->offset_rad, 0.1);
  record.set(4, {0.2, 1, -1, 1}, "a note");
  EXPECT_EQ(load_calibration(path_).joints[3]->offset_rad, 0.1);
  EXPECT_EQ(load_calibration(path_).joints[4]->offset_rad, 0.2);
  EXPECT_EQ(record.calibration().joints[4]->offset_rad, 0.2);
  EXPECT_EQ(files(), 1) << "no draft is left";
}

TEST_F(CalibrationRecord, GoesOnWhereItWasLeft) {
  { Record(path_).set(3, {0.1, -1, -1, 1}, "first"); }
  Record again(path_);
  ASSERT_TRUE(again.calibration().joints[3].has_value());
  again.set(5, {0.3, 1, -1, 1}, "second");
  EXPECT_THAT(test::read_text(path_),
              testing::AllOf(testing::HasSubstr("# first"), testing::HasSubstr("# second")));
}

TEST_F(CalibrationRecord, KeepsTheFileWhenAnEntryIsNoGood) {
  Record record(path_);
  record.set(3, {0.1, -1, -1, 1}, "a note");
  const std::string before = test::read_text(path_);
  EXPECT_THROW(record.set(4, {3, 1, -1, 1}, "offset beyond the range"), config::Error);
  EXPECT_EQ(test::read_text(path_), before);
  EXPECT_EQ(files(), 1);
  EXPECT_FALSE(record.calibration().joints[4].has_value());
}

TEST_F(CalibrationRecord, RefusesAFileThatIsNone) {
  test::write_text(path_, "TL0: perhaps\n");
  EXPECT_THROW(Record{path_}, config::Error);
}

TEST_F(CalibrationRecord, SaysWhereItCannotWrite) {
  Record record(directory_ / "not" / "there.yaml");
  try {
    record.set(0, {0, 1, -1, 1}, "a note");
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("there.yaml"));
  }
}

}  // namespace
}  // namespace scarab::bridge::calibrate
