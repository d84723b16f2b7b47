/// What a log says of itself.
#include "tools/log/info.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/unit/log/behaviour_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"
#include "tools/log/extraction.hpp"

namespace scarab::log::test {
namespace {

using mcap::test::TemporaryFolder;
using testing::ContainsRegex;
using testing::HasSubstr;

scarab_RobotState state(std::uint32_t trial, std::uint32_t tick, bool real_time) {
  scarab_RobotState s{};
  s.header = {trial, tick, tick * 100'000'000LL, 0};
  s.real_time = real_time;
  return s;
}

class Info : public testing::Test {
 protected:
  Info() {
    LogWriter log(folder_ / "x.mcap");
    scarab_Trial trial{};
    trial.header.trial = 1;
    bus::assign(trial.strategy, "soft+hard");
    log.write(bus::kTrial, trial, 0);
    for (std::uint32_t tick = 0; tick < 4; ++tick) {
      log.write(bus::kRobotState, state(1, tick, false), kSecond * tick);
    }
    log.write(bus::kRobotState, state(2, 7, true), kSecond * 5);
    const auto channel = log.writer().add_channel(0, "camera", "jpeg",
                                                  {{"type", "cam::Image"},
                                                   {"writers", "camera/0"},
                                                   {"qos.reliability", "best-effort"},
                                                   {"qos.ownership", "shared"},
                                                   {"qos.partition.0", "left"}});
    log.write(channel, 0, std::string_view("x"));
    log.writer().attach({0, 0, "config/a.yaml", "application/yaml", {'a'}});
    log.writer().add_metadata({"scarab.recorded", {{"dropped", "12"}, {"dropped.camera", "12"}}});
    log.close();
  }
  std::string text() const {
    std::ostringstream out;
    print_info(gather_facts(Log(folder_ / "x.mcap")), out);
    return out.str();
  }
  TemporaryFolder folder_;
};

TEST_F(Info, NamesTrialsTopicsCountsAndAttachments) {
  EXPECT_THAT(text(), HasSubstr("closed       yes"));
  EXPECT_THAT(text(),
              HasSubstr("trial 1      soft+hard, ticks 0 to 3, 0.3 s simulated, in lockstep"));
  EXPECT_THAT(text(), HasSubstr("trial 2      ticks 7 to 7, 0.7 s simulated, in real time"));
  EXPECT_THAT(text(), ContainsRegex("scarab/robot_state +scarab::RobotState +5 +0.8/s"));
  EXPECT_THAT(text(), HasSubstr("config/a.yaml"));
}

TEST_F(Info, NamesWritersQosAndWhatWasDropped) {
  EXPECT_THAT(text(), HasSubstr("dropped: 12 samples that the recorder could not keep"));
  EXPECT_THAT(
      text(),
      ContainsRegex(
          "camera +cam::Image +1 .*by camera/0, best-effort, partition left  \\(12 dropped\\)"));
  EXPECT_THAT(text(), HasSubstr("shown as bytes: its messages are in 'jpeg'"));
}

TEST_F(Info, IsJsonToo) {
  std::ostringstream out;
  print_info_json(gather_facts(Log(folder_ / "x.mcap")), out);
  EXPECT_THAT(out.str(), HasSubstr("\"pace\": \"lockstep\""));
  EXPECT_THAT(out.str(), HasSubstr("\"pace\": \"realtime\""));
  EXPECT_THAT(out.str(), HasSubstr("\"dropped\": 12"));
  EXPECT_THAT(out.str(), HasSubstr("{\"name\": \"config/a.yaml\", \"media_type\": "
                                   "\"application/yaml\", \"size\": 1}"));
}

TEST_F(Info, AttachmentsAreExtractedButNeverOutsideOfTheFolder) {
  extract_attachments(mcap::Reader(folder_ / "x.mcap"), folder_ / "out");  // the same again
  const auto files = extract_attachments(mcap::Reader(folder_ / "x.mcap"), folder_ / "out");
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(mcap::test::read_file(folder_ / "out" / "config" / "a.yaml"), mcap::Bytes{'a'});
  LogWriter evil(folder_ / "evil.mcap");
  evil.writer().attach({0, 0, "../evil", "text/plain", {}});
  evil.close();
  EXPECT_THROW(extract_attachments(mcap::Reader(folder_ / "evil.mcap"), folder_ / "out"),
               std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "evil"));
}

TEST_F(Info, ACutLogIsSaidToBeRecoverable) {
  std::filesystem::resize_file(folder_ / "x.mcap",
                               std::filesystem::file_size(folder_ / "x.mcap") - 30);
  std::ostringstream out;
  warn_if_cut(Log(folder_ / "x.mcap"), out);
  EXPECT_THAT(out.str(), HasSubstr("not closed"));
  EXPECT_THAT(out.str(), HasSubstr("scarab-log recover"));
}

TEST(SeveralFiles, AreReadAsOneLogInTheOrderOfTime) {
  const TemporaryFolder folder;
  std::uint32_t tick = 0;
  for (const char* name : {"z.mcap", "y-1.mcap", "y-10.mcap.active"}) {
    LogWriter log(folder / name);
    log.skip(tick);
    for (int i = 0; i < 3; ++i) log.write(behaviour(1, tick++, 0));
    log.close();
  }
  const Log log(folder / "");
  EXPECT_EQ(log.files().size(), 3U);
  EXPECT_EQ(log.count("scarab/behaviour"), 9U);
  EXPECT_EQ(log.topics(), std::set<std::string>{"scarab/behaviour"});
  std::vector<std::uint32_t> ticks;
  log.for_each([&](const LogChannel& channel, const mcap::Message& message) {
    EXPECT_TRUE(channel.has_header);
    ticks.push_back(bus::decode<scarab_Behaviour>(cdr_of(message))->header.tick);
    return ticks.size() < 8;
  });
  EXPECT_THAT(ticks, testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST(SeveralFiles, ADirectoryWithoutLogsIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(Log(folder / ""), std::invalid_argument);
}

}  // namespace
}  // namespace scarab::log::test
