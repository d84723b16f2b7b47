#include "services/experiment/worker.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <sstream>
#include <stdexcept>
#include <vector>

#include "tests/unit/experiment/trial_text.hpp"

namespace scarab::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// A pipe whose other end has written `text`.
class Input {
 public:
  Input(const std::string& text, bool ended) {
    EXPECT_EQ(::pipe(ends_), 0);
    EXPECT_EQ(::write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    if (ended) close_writer();
  }
  ~Input() {
    ::close(ends_[0]);
    close_writer();
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  [[nodiscard]] int reader() const { return ends_[0]; }

 private:
  void close_writer() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  int ends_[2] = {-1, -1};
};

class WorkerTest : public testing::Test {
 protected:
  int work_through(const std::string& text, bool ended = true) {
    const Input input(text, ended);
    worker_.input = input.reader();
    worker_.output = &output_;
    if (!worker_.interrupted) worker_.interrupted = [] { return false; };
    if (!worker_.run) worker_.run = [this](const auto& line, auto n) { return run(line, n); };
    return work(worker_);
  }
  Outcome run(const TrialLine& line, std::uint32_t n) {
    seeds_.push_back(line.seed);
    numbers_.push_back(n);
    Outcome outcome;
    outcome.judged = true;
    outcome.reason = "too slow";
    return outcome;
  }
  [[nodiscard]] std::vector<std::string> rows() const {
    std::vector<std::string> rows;
    std::istringstream text(output_.str());
    for (std::string row; std::getline(text, row);) rows.push_back(row);
    return rows;
  }

  Worker worker_;
  std::ostringstream output_;
  std::vector<std::uint64_t> seeds_;
  std::vector<std::uint32_t> numbers_;
};

TEST_F(WorkerTest, NothingToDoIsAllDone) {
  EXPECT_EQ(work_through(""), 0);
  EXPECT_TRUE(rows().empty());
}

TEST_F(WorkerTest, RunsEachLineInItsOrder) {
  const auto second = trial_text_with("1000001", "5");
  EXPECT_EQ(work_through(trial_text() + "\n" + second + "\n"), 0);
  EXPECT_THAT(seeds_, ElementsAre(1000001, 5));
  EXPECT_THAT(numbers_, ElementsAre(1, 2));
  EXPECT_THAT(rows(), ElementsAre(HasSubstr(R"("seed": 1000001)"), HasSubstr(R"("seed": 5)")));
}

TEST_F(WorkerTest, AFailedTrialIsAResult) {
  EXPECT_EQ(work_through(trial_text() + "\n"), 0);
  EXPECT_THAT(rows(), ElementsAre(HasSubstr(R"("success": false)")));
}

TEST_F(WorkerTest, TheLastLineMayLackItsEnd) {
  EXPECT_EQ(work_through(trial_text()), 0);
  EXPECT_EQ(rows().size(), 1U);
}

TEST_F(WorkerTest, LongLinesAreLines) {
  const auto text = trial_text_with(", \"seed\"", "," + std::string(10000, ' ') + "\"seed\"");
  EXPECT_EQ(work_through(text + "\n" + text + "\n"), 0);
  EXPECT_EQ(rows().size(), 2U);
}

TEST_F(WorkerTest, ABadLineEndsItAsBadUsage) {
  EXPECT_EQ(work_through(trial_text() + "\n{\"index\": 8}\n" + trial_text() + "\n"), 2);
  ASSERT_EQ(rows().size(), 2U);
  EXPECT_THAT(rows()[1], StartsWith(R"({"error": "trial line 2:)"));
  EXPECT_EQ(seeds_.size(), 1U);
}

TEST_F(WorkerTest, ATrialWithoutAResultEndsIt) {
  worker_.run = [](const TrialLine&, std::uint32_t) -> Outcome {
    throw std::runtime_error("unknown strategy");
  };
  EXPECT_EQ(work_through(trial_text() + "\n" + trial_text() + "\n"), 1);
  EXPECT_THAT(rows(), ElementsAre(R"({"index": 7, "error": "unknown strategy"})"));
}

TEST_F(WorkerTest, ATrialThatNobodyJudgedHasNoResult) {
  worker_.run = [](const TrialLine&, std::uint32_t) {
    Outcome outcome;
    outcome.reason = "plant/0 is gone";
    return outcome;
  };
  EXPECT_EQ(work_through(trial_text() + "\n"), 1);
  EXPECT_THAT(rows(), ElementsAre(R"({"index": 7, "error": "plant/0 is gone"})"));
}

TEST_F(WorkerTest, ATrialNotWhollySeenHasNoResult) {
  worker_.run = [](const TrialLine&, std::uint32_t) {
    Outcome outcome;
    outcome.judged = outcome.success = true;
    outcome.missed = "world_state of 1.000 s was missed";
    return outcome;
  };
  EXPECT_EQ(work_through(trial_text() + "\n"), 1);
  EXPECT_THAT(rows(), ElementsAre(HasSubstr(R"("error": "world_state of 1.000 s was missed")")));
}

TEST_F(WorkerTest, ATrialUnderWayIsLeftWithoutARow) {
  worker_.run = [](const TrialLine&, std::uint32_t) -> Outcome { throw Interrupted{}; };
  EXPECT_EQ(work_through(trial_text() + "\n"), 130);
  EXPECT_TRUE(rows().empty());
}

TEST_F(WorkerTest, TheWaitForALineCanBeInterrupted) {
  int asked = 0;
  worker_.interrupted = [&asked] { return ++asked > 2; };
  EXPECT_EQ(work_through(trial_text() + "\n", false), 130);
  EXPECT_EQ(rows().size(), 1U);
}

TEST_F(WorkerTest, ARowThatCannotBeWrittenIsNoResult) {
  output_.setstate(std::ios::badbit);
  EXPECT_THROW(work_through(trial_text() + "\n" + trial_text() + "\n"), std::runtime_error);
  EXPECT_EQ(seeds_.size(), 1U);
}

}  // namespace
}  // namespace scarab::experiment
