/// Logs of real runs: readers of others (npm) agree with scarab-log, value by value.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "common/mcap/reader.hpp"
#include "common/mcap/writer.hpp"
#include "tests/interop/mcap/npm_readers.hpp"
#include "tests/support/files.hpp"
#include "tests/system/stack.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

class RealRun : public testing::Test {
 protected:
  /// The main trial on a stack of its own; `recorder_killed`: at its end, with kill -9.
  std::filesystem::path record(bool recorder_killed = false) {
    Stack stack(directory_ / "run");
    auto experiment = stack.conduct(main_trial());
    EXPECT_EQ(experiment.wait(std::chrono::seconds(30)), 0)
        << experiment.output() << stack.errors();
    if (recorder_killed) {
      stack.kill("logger");
    } else {
      EXPECT_TRUE(stack.stop()) << stack.errors();
    }
    return stack.log();
  }

  /// What `scarab-log cat --json` prints, as a file.
  std::filesystem::path cat(const std::filesystem::path& log) {
    return printed({"cat", log, "--json"}, log.filename().string() + ".json");
  }

  std::filesystem::path printed(Arguments arguments, const std::string& name) {
    arguments.insert(arguments.begin(), program("scarab-log"));
    const Finished result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    write_text(directory_ / name, result.out);
    return directory_ / name;
  }

  void expect_agreement(const std::filesystem::path& log, const std::string& how) {
    const Finished result = readers_.run("compare_cat.mjs", {log, cat(log)});
    EXPECT_EQ(result.exit_code, 0) << log << ": " << result.err;
    EXPECT_THAT(result.out, HasSubstr("messages of 8 topics agree"));
    EXPECT_THAT(result.out, HasSubstr(how));
    std::cout << log.filename() << ": " << result.out;
  }

  /// The same messages with their chunks compressed in another way.
  std::filesystem::path rewritten(const std::filesystem::path& log, mcap::Compression compression,
                                  const std::string& name) {
    const mcap::Reader reader(log);
    mcap::WriterOptions options;
    options.compression = compression;
    mcap::Writer writer(directory_ / name, options);
    std::map<std::uint16_t, std::uint16_t> ids;
    for (const auto& [id, channel] : reader.summary().channels) {
      const auto& schema = reader.summary().schemas.at(channel.schema_id);
      ids[id] = writer.add_channel(writer.add_schema(schema.name, schema.encoding, schema.data),
                                   channel.topic, channel.message_encoding);
    }
    reader.for_each([&](const mcap::Channel& channel, const mcap::Message& message) {
      mcap::Message copy = message;
      copy.channel_id = ids.at(channel.id);
      writer.write(copy);
    });
    writer.close();
    return directory_ / name;
  }

  TemporaryDirectory directory_;
  NpmReaders readers_;
};

TEST_F(RealRun, EveryMessageIsToOthersWhatCatPrintsHoweverItIsCompressed) {
  const auto log = record();
  expect_agreement(log, "zstd");
  expect_agreement(rewritten(log, mcap::Compression::kLz4, "lz4.mcap"), "lz4");
  expect_agreement(rewritten(log, mcap::Compression::kNone, "none.mcap"), "none");

  // The comparison is not blind: one digit, and they disagree.
  std::string text = read_text(cat(log));
  char& digit = text.at(text.find('.', text.size() / 2) + 1);
  digit = digit == '9' ? '0' : static_cast<char>(digit + 1);
  write_text(directory_ / "changed.json", text);
  EXPECT_EQ(readers_.run("compare_cat.mjs", {log, directory_ / "changed.json"}).exit_code, 1);
}

TEST_F(RealRun, AMendedLogOfAKilledRecorderAgreesToo) {
  auto active = record(true);
  active += ".active";
  const Finished mended =
      run({program("scarab-log"), "recover", active, directory_ / "mended.mcap"});
  ASSERT_EQ(mended.exit_code, 0) << mended.err;
  expect_agreement(directory_ / "mended.mcap", "zstd");
}

TEST_F(RealRun, EveryValueIsToOthersWhatExportTabulates) {
  const auto log = record();
  constexpr const char* kElements = "3";
  const mcap::Reader reader(log);
  for (const auto& [id, channel] : reader.summary().channels) {
    std::string name = channel.topic + ".csv";
    std::replace(name.begin(), name.end(), '/', '.');
    printed({"export", log, "--topic", channel.topic, "--format", "csv", "--times", "--elements",
             kElements},
            name);
  }
  const Finished result = readers_.run("compare_csv.mjs", {log, directory_.path(), kElements});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("of 8 tables agree"));
  std::cout << result.out;
}

}  // namespace
}  // namespace scarab::test
