/// What scarab-log finds in logs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "common/bus/cdr.hpp"
#include "common/bus/idl_text.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/writer.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"
#include "tools/log/comparison.hpp"
#include "tools/log/csv.hpp"
#include "tools/log/extraction.hpp"
#include "tools/log/info.hpp"

namespace scarab::log {
namespace {

using mcap::test::TemporaryFolder;
using testing::HasSubstr;

/// Writes scarab/behaviour and, when asked, other topics.
class Log {
 public:
  explicit Log(const std::filesystem::path& path) : writer_(path) {
    const auto type = bus::TypeModel::from_descriptor(bus::descriptor<scarab_Behaviour>());
    channel_ =
        writer_.add_channel(writer_.add_schema("scarab::Behaviour", "omgidl", bus::idl_text(type)),
                            "scarab/behaviour", "cdr");
  }
  void write(const scarab_Behaviour& behaviour) {
    const bus::Bytes bytes = bus::encode(behaviour);
    writer_.write({channel_,
                   sequence_,
                   kSecond * (sequence_ + 1),
                   kSecond * sequence_,
                   {bytes.data(), bytes.size()}});
    ++sequence_;
  }
  mcap::Writer& writer() { return writer_; }

 private:
  static constexpr std::uint64_t kSecond = 1'000'000'000;
  mcap::Writer writer_;
  std::uint16_t channel_ = 0;
  std::uint32_t sequence_ = 0;
};

scarab_Behaviour behaviour(std::uint32_t trial, std::uint32_t tick, std::int64_t stamp) {
  scarab_Behaviour b{};
  b.header = {trial, tick, tick * 100'000'000LL, stamp};
  b.mode = scarab_MODE_BACKWARD;
  bus::assign(b.reason, "walks, \"slowly\"");
  return b;
}

class Compare : public testing::Test {
 protected:
  /// Two logs of trials 1 and 2 with ten ticks each, the second after `change` has been at its
  /// samples.
  TopicComparison compare(const std::function<void(std::vector<scarab_Behaviour>&)>& change) {
    const TemporaryFolder folder;
    std::vector<scarab_Behaviour> samples;
    for (std::uint32_t i = 0; i < 20; ++i) samples.push_back(behaviour(1 + i / 10, i % 10, i));
    write(folder / "a.mcap", samples);
    for (auto& sample : samples) sample.header.stamp_ns += 1000;
    change(samples);
    write(folder / "b.mcap", samples);
    return compare_topic(mcap::Reader(folder / "a.mcap"), mcap::Reader(folder / "b.mcap"),
                         "scarab/behaviour");
  }

 private:
  static void write(const std::filesystem::path& path,
                    const std::vector<scarab_Behaviour>& samples) {
    Log log(path);
    for (const auto& sample : samples) log.write(sample);
    log.writer().close();
  }
};

TEST_F(Compare, WallClockStampsDoNotCount) {
  const auto result = compare([](auto&) {});
  EXPECT_EQ(result.difference, "");
  EXPECT_EQ(result.equal_samples, 20U);
}

TEST_F(Compare, NamesTheFirstFieldThatDiffers) {
  const auto result = compare([](auto& samples) {
    samples[13].inputs[2] = 0.25;
    samples[17].mode = scarab_MODE_STOP;
  });
  EXPECT_EQ(result.equal_samples, 13U);
  EXPECT_EQ(result.difference, "trial 2, tick 3 (0.3 s): inputs[2]: 0 and 0.25");
  EXPECT_THAT(compare([](auto& samples) { samples[4].mode = scarab_MODE_STOP; }).difference,
              HasSubstr("trial 1, tick 4 (0.4 s): mode: MODE_BACKWARD and MODE_STOP"));
}

TEST_F(Compare, ASampleThatOneLogLacksIsADifference) {
  EXPECT_THAT(compare([](auto& samples) { samples.pop_back(); }).difference,
              HasSubstr("trial 2, tick 9 (0.9 s): only the first has it"));
  EXPECT_THAT(compare([](auto& samples) { samples.erase(samples.begin() + 2); }).difference,
              HasSubstr("the first has trial 1, tick 2"));
  EXPECT_THAT(compare([](auto& samples) { samples.push_back(behaviour(3, 0, 0)); }).difference,
              HasSubstr("trial 3, tick 0 (0 s): only the second has it"));
}

TEST_F(Compare, TheSameAnswerGivenTwiceCountsOnceAndOrderOfReceptionNot) {
  EXPECT_EQ(compare([](auto& samples) {
              samples.insert(samples.begin() + 5, samples[4]);  // a restarted service's last answer
              std::swap(samples[0], samples[15]);
            }).difference,
            "");
  EXPECT_NE(compare([](auto& samples) {
              samples.insert(samples.begin() + 5, samples[4]);
              samples[5].as_rad = 1;  // another answer to the same tick
            }).difference,
            "");
}

class Table : public testing::Test {
 protected:
  Table() {
    Log log(folder_ / "x.mcap");
    log.write(behaviour(1, 0, 5));
    log.write(behaviour(2, 1, 6));
    log.writer().attach({0, 0, "config/a.yaml", "application/yaml", {'a'}});
    log.writer().close();
  }
  std::string csv(const CsvOptions& options) const {
    std::ostringstream out;
    write_csv(mcap::Reader(folder_ / "x.mcap"), options, out);
    return out.str();
  }
  TemporaryFolder folder_;
};

TEST_F(Table, HasTheFieldsAskedForWithEnumsByNameAndTextQuoted) {
  EXPECT_EQ(csv({"scarab/behaviour", {}, {"header.tick", "mode", "hind_pose_rad", "reason"}}),
            "header.tick,mode,hind_pose_rad[0],hind_pose_rad[1],hind_pose_rad[2],reason\n"
            "0,MODE_BACKWARD,0,0,0,\"walks, \"\"slowly\"\"\"\n"
            "1,MODE_BACKWARD,0,0,0,\"walks, \"\"slowly\"\"\"\n");
  EXPECT_EQ(csv({"scarab/behaviour", 2, {"header.trial", "header.tick"}}),
            "header.trial,header.tick\n2,1\n");
  EXPECT_EQ(csv({"scarab/behaviour", 1, {"header.tick"}, 0, true}),
            "log_time_ns,publish_time_ns,header.tick\n1000000000,0,0\n");
}

TEST_F(Table, SaysWhichTopicsAndFieldsThereAre) {
  const auto message = [&](const CsvOptions& options) -> std::string {
    try {
      return csv(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_THAT(message({"scarab/nothing", {}, {}}), HasSubstr("there are scarab/behaviour"));
  EXPECT_THAT(message({"scarab/behaviour", {}, {"mod"}}), HasSubstr("no field mod; there are"));
}

TEST_F(Table, InfoNamesTopicsCountsAndAttachments) {
  std::ostringstream out;
  print_info(mcap::Reader(folder_ / "x.mcap"), out);
  EXPECT_THAT(out.str(), HasSubstr("closed       yes"));
  EXPECT_THAT(out.str(), testing::ContainsRegex("scarab/behaviour +scarab::Behaviour +2 +2.0/s"));
  EXPECT_THAT(out.str(), HasSubstr("config/a.yaml"));
}

TEST_F(Table, AttachmentsAreExtractedButNeverOutsideOfTheFolder) {
  const auto files = extract_attachments(mcap::Reader(folder_ / "x.mcap"), folder_ / "out");
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(mcap::test::read_file(folder_ / "out" / "config" / "a.yaml"), mcap::Bytes{'a'});
  Log evil(folder_ / "evil.mcap");
  evil.writer().attach({0, 0, "../evil", "text/plain", {}});
  evil.writer().close();
  EXPECT_THROW(extract_attachments(mcap::Reader(folder_ / "evil.mcap"), folder_ / "out"),
               std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "evil"));
}

TEST_F(Table, ACutLogIsSaidToBeRecoverable) {
  std::filesystem::resize_file(folder_ / "x.mcap",
                               std::filesystem::file_size(folder_ / "x.mcap") - 30);
  std::ostringstream out;
  warn_if_cut(mcap::Reader(folder_ / "x.mcap"), out);
  EXPECT_THAT(out.str(), HasSubstr("not closed"));
  EXPECT_THAT(out.str(), HasSubstr("scarab-log recover"));
}

}  // namespace
}  // namespace scarab::log
