/// Whole files of cut ones.
#include "tools/log/mending.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/mcap/reader.hpp"
#include "tests/unit/log/behaviour_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"
#include "tools/log/log.hpp"

namespace scarab::log::test {
namespace {

using mcap::test::TemporaryFolder;
using Paths = std::vector<std::filesystem::path>;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Mend : public testing::Test {
 protected:
  /// A log of a recorder that was killed: ten messages in closed chunks, then half a record.
  std::filesystem::path cut(const std::string& name) {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    {
      LogWriter log(path);
      for (std::uint32_t i = 0; i < 10; ++i) log.write(behaviour(1, i, 0));
      log.writer().close_chunk();
    }
    const std::filesystem::path active = path.string() + ".active";
    mcap::Bytes bytes = mcap::test::read_file(active);
    bytes.insert(bytes.end(), 12, 0xEE);
    mcap::test::write_file(active, bytes);
    return active;
  }
  TemporaryFolder folder_;
};

TEST_F(Mend, InPlaceTheActiveFileBecomesTheWholeOne) {
  const auto active = cut("x.mcap");
  const Mending mending = mend(active, std::nullopt);
  EXPECT_EQ(mending.to, folder_ / "x.mcap");
  EXPECT_EQ(mending.recovery.kept.message_count, 10U);
  EXPECT_EQ(mending.recovery.bytes_lost, 12U);
  EXPECT_FALSE(std::filesystem::exists(active));
  const mcap::Reader reader(folder_ / "x.mcap");
  EXPECT_TRUE(reader.closed());
  EXPECT_EQ(reader.summary().statistics.message_count, 10U);
  const std::string said = to_string(active, mending);
  EXPECT_THAT(said, HasSubstr("x.mcap: 10 messages of 10 chunks, 0 attachments"));
  EXPECT_THAT(said,
              HasSubstr("lost: what its recorder had not written yet when it ended, and 12 bytes"));
  EXPECT_THAT(said, HasSubstr("removed: "));
}

TEST_F(Mend, OfAFileThatWasWholeNothingIsLost) {
  {
    LogWriter log(folder_ / "x.mcap");
    log.write(behaviour(1, 0, 0));
    log.close();
  }
  const Mending mending = mend(folder_ / "x.mcap", folder_ / "y.mcap");
  const std::string said = to_string(folder_ / "x.mcap", mending);
  EXPECT_THAT(said, HasSubstr("nothing lost: it had been closed"));
  EXPECT_THAT(said, Not(HasSubstr("lost: what its recorder")));
}

TEST_F(Mend, OfACutFileAndItsMendedCopyEachSampleIsReadOnce) {
  const auto active = cut("x.mcap");
  mend(active, folder_ / "y.mcap");
  EXPECT_EQ(Log(folder_ / "").count(), 10U);
  const Log log(Paths{active, folder_ / "y.mcap"});
  EXPECT_EQ(log.count(), 10U);
  EXPECT_THAT(log.passed_over(), ElementsAre(active));
  EXPECT_EQ(Log(active).count(), 10U) << "by itself it is what is meant";
}

TEST_F(Mend, ACutFileOfTheSameNameThatIsAnotherRecordingIsRead) {
  mend(cut("elsewhere/x.mcap"), folder_ / "y.mcap");
  LogWriter log(folder_ / "x.mcap");
  for (std::uint32_t i = 0; i < 3; ++i) log.write(behaviour(2, i, 0));
  log.writer().close_chunk();
  EXPECT_EQ(Log(Paths{folder_ / "y.mcap", folder_ / "x.mcap.active"}).count(), 13U);
}

TEST_F(Mend, IntoAnotherFileTheCutOneStays) {
  const auto active = cut("x.mcap");
  EXPECT_EQ(mend(active, folder_ / "y.mcap").recovery.kept.message_count, 10U);
  EXPECT_TRUE(std::filesystem::exists(active));
  EXPECT_TRUE(mcap::Reader(folder_ / "y.mcap").closed());
}

TEST_F(Mend, NothingIsEverOverwritten) {
  const auto active = cut("x.mcap");
  mcap::test::write_file(folder_ / "x.mcap", std::string_view("precious"));
  EXPECT_THROW(mend(active, std::nullopt), mcap::FileError);
  EXPECT_EQ(mcap::test::read_file(folder_ / "x.mcap").size(), 8U);
  EXPECT_TRUE(std::filesystem::exists(active));
  EXPECT_THROW(mend(active, active), mcap::FileError);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "")) {
    files += entry.exists() ? 1U : 0U;
  }
  EXPECT_EQ(files, 2U) << "no trace of what was refused";
}

TEST_F(Mend, ADamagedFileIsKept) {
  const auto active = cut("x.mcap");
  mcap::Bytes bytes = mcap::test::read_file(active);
  const mcap::Reader reader(active);
  bytes.at(reader.summary().chunks.at(3).offset + 60) ^= 1U;
  mcap::test::write_file(active, bytes);
  const Mending mending = mend(active, std::nullopt);
  EXPECT_EQ(mending.recovery.kept.message_count, 9U);
  EXPECT_EQ(mending.recovery.damaged, 1U);
  EXPECT_TRUE(std::filesystem::exists(active));
  EXPECT_THAT(to_string(active, mending), HasSubstr("left out: 1 damaged record"));
}

TEST_F(Mend, AFileThatIsBeingWrittenIsLeftAlone) {
  LogWriter log(folder_ / "x.mcap");
  log.write(behaviour(1, 0, 0));
  log.writer().close_chunk();
  const std::filesystem::path active = (folder_ / "x.mcap").string() + ".active";
  EXPECT_TRUE(is_being_written(active));
  try {
    mend(active, std::nullopt);
    FAIL() << "no refusal";
  } catch (const mcap::FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is being written"));
  }
  log.close();
  EXPECT_FALSE(is_being_written(folder_ / "x.mcap"));
}

TEST_F(Mend, AWholeFileNeedsNone) {
  {
    LogWriter log(folder_ / "x.mcap");
    log.write(behaviour(1, 0, 0));
    log.close();
  }
  EXPECT_TRUE(mend(folder_ / "x.mcap", std::nullopt).to.empty());
  EXPECT_EQ(mended_name(folder_ / "x.mcap"), folder_ / "x.mended.mcap");
}

TEST_F(Mend, FindsTheCutLogsOfADirectory) {
  const auto one = cut("a/1/trial.mcap");
  const auto two = cut("a/2/trial-2.mcap");
  mcap::test::write_file(folder_ / "a" / "other.active", std::string_view("x"));
  EXPECT_THAT(cut_logs(folder_ / "a"), ElementsAre(one, two));
}

}  // namespace
}  // namespace scarab::log::test
