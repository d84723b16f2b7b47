/// Files that are whole or not there.
#include "tools/log/output_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <ostream>
#include <stdexcept>

#include "common/mcap/writer.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"
#include "tools/log/unfinished_file.hpp"

namespace scarab::log::test {
namespace {

using mcap::test::TemporaryFolder;
using testing::ExitedWithCode;

class OutputFile : public testing::Test {
 protected:
  std::string content(const std::string& name) const {
    const mcap::Bytes bytes = mcap::test::read_file(folder_ / name);
    return {bytes.begin(), bytes.end()};
  }
  std::size_t files() const {
    const std::filesystem::directory_iterator all(folder_ / "");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  TemporaryFolder folder_;
};

TEST_F(OutputFile, TakesThePlaceOfAnotherOneWhenItIsWhole) {
  mcap::test::write_file(folder_ / "x.csv", std::string_view("old"));
  write_file(folder_ / "x.csv", [&](std::ostream& out) {
    out << "new" << std::flush;
    EXPECT_EQ(content("x.csv"), "old");
  });
  EXPECT_EQ(content("x.csv"), "new");
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFile, ThatFailsLeavesWhatWasThere) {
  mcap::test::write_file(folder_ / "x.csv", std::string_view("old"));
  const auto fail = [](std::ostream& out) {
    out << "half" << std::flush;
    throw std::runtime_error("the log is damaged");
  };
  EXPECT_THROW(write_file(folder_ / "x.csv", fail), std::runtime_error);
  EXPECT_EQ(content("x.csv"), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFile, NeverReplacesALog) {
  mcap::Writer(folder_ / "x.mcap").close();
  const std::string before = content("x.mcap");
  EXPECT_THROW(write_file(folder_ / "x.mcap", [](std::ostream& out) { out << "a,b\n"; }),
               std::invalid_argument);
  EXPECT_EQ(content("x.mcap"), before);
}

TEST_F(OutputFile, WhatIsNoRegularFileIsWrittenInto) {
  EXPECT_NO_THROW(write_file("/dev/null", [](std::ostream& out) { out << "a,b\n"; }));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_THROW(write_file("/dev/full", [](std::ostream& out) { out << "a,b\n"; }),
               std::runtime_error);
  EXPECT_THROW(write_file(folder_ / "", [](std::ostream&) {}), std::runtime_error);
  EXPECT_THROW(write_file(folder_ / "none" / "x.csv", [](std::ostream&) {}), std::runtime_error);
}

TEST_F(OutputFile, AnUnfinishedOneIsGoneAfterASignal) {
  for (const int signal : {SIGINT, SIGTERM}) {
    EXPECT_EXIT(write_file(folder_ / "x.csv",
                           [&](std::ostream& out) {
                             out << "half" << std::flush;
                             ::raise(signal);
                           }),
                ExitedWithCode(130), "");
    EXPECT_EQ(files(), 0U);
  }
}

}  // namespace
}  // namespace scarab::log::test
