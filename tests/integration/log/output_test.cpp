/// scarab-log and what a shell does with its output, and with its files.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <csignal>
#include <sstream>

#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/unit/log/behaviour_log.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

class LogOutput : public testing::Test {
 protected:
  LogOutput() {
    log::test::LogWriter log(log_);
    for (std::uint32_t i = 0; i < kSamples; ++i) log.write(log::test::behaviour(1, i, 0));
    log.close();
  }
  /// A line for the shell; `LOG` is scarab-log and `$X` the log.
  Finished shell(const std::string& line) const {
    return run(
        {"/bin/bash", "-c",
         "LOG() { " + program("scarab-log") + " \"$@\"; }; X=" + log_.string() + "; " + line});
  }
  static constexpr std::uint32_t kSamples = 3000;
  TemporaryDirectory directory_;
  std::filesystem::path log_ = directory_ / "x.mcap";
};

TEST_F(LogOutput, ThatCannotBeWrittenIsAFailureOfEveryCommand) {
  for (const std::string words :
       {"info $X", "cat $X", "export $X --topic scarab/behaviour", "recover $X"}) {
    const Finished result = shell("LOG " + words + " > /dev/full");
    EXPECT_EQ(result.exit_code, 1) << words;
    EXPECT_EQ(result.err, "scarab-log: cannot write all of the output\n") << words;
  }
  EXPECT_EQ(shell("LOG diff $X $X > /dev/full").exit_code, 2) << "1 is a difference";
}

TEST_F(LogOutput, EndsWhenNobodyReadsIt) {
  // Python starts its children with SIGPIPE ignored, and the launcher is Python.
  const Finished result = shell("trap '' PIPE; LOG cat $X | head -n 1; echo ${PIPESTATUS[0]}");
  EXPECT_EQ(result.out, "---\n" + std::to_string(128 + SIGPIPE) + "\n") << result.err;
}

TEST_F(LogOutput, ATableNeverTakesThePlaceOfALog) {
  const std::string before = read_text(log_);
  const Finished result = shell("LOG export $X --topic scarab/behaviour --output $X");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("is a log"));
  EXPECT_EQ(read_text(log_), before);
}

TEST_F(LogOutput, APipeIsRefusedAndNotWaitedFor) {
  const std::string pipe = directory_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string words : {"info ", "recover ", "replay "}) {
    const Finished result = shell("LOG " + words + pipe);
    EXPECT_EQ(result.exit_code, 1) << words;
    EXPECT_THAT(result.err, HasSubstr("it is no regular file")) << words;
  }
}

TEST_F(LogOutput, SlipsAreSaidInOneLine) {
  const std::vector<std::pair<std::string, std::string>> slips = {
      {"cat $X -n 0", "-n: Value 0 is too small"},
      {"cat $X -n -1", "-n: Value -1 is too small"},
      {"export $X --topic scarab/behaviour --elements -1", "--elements: Value -1 is too small"},
      {"diff $X $X --ignore reasn", "--ignore reasn: no topic has such a field"},
      {"diff $X $X --tolerance nan", "--tolerance nan"},
      {"replay $X --from 5 --to 3", "--to 3.000 is before --from 5.000"},
      {"replay $X --from nan", "--from"},
      {"replay $X --timeout 1e300", "--timeout"},
      {"replay $X --against premotor/99999999999", "a service is meant"},
      {"replay $X --trial 9 --tag " + directory_.path().filename().string(),
       "no sample of the log"},
  };
  for (const auto& [words, said] : slips) {
    const Finished result = shell("LOG " + words);
    EXPECT_EQ(result.exit_code, 2) << words << result.err;
    EXPECT_THAT(result.err, HasSubstr(said));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

}  // namespace
}  // namespace scarab::test
