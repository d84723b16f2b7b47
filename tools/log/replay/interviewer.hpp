#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>

#include "common/runtime/status_board.hpp"
#include "tools/log/progress_line.hpp"
#include "tools/log/replay/answer_book.hpp"
#include "tools/log/replay/cast.hpp"
#include "tools/log/replay/excerpt.hpp"
#include "tools/log/replay/operator_words.hpp"
#include "tools/log/replay/options.hpp"
#include "tools/log/replay/pace.hpp"

namespace scarab::log {

/// The service does not do its part; what() says so.
class Silence : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Asks one service what was asked in a log; see interview().
class Interviewer {
 public:
  Interviewer(const Log& log, const ReplayOptions& replay, const InterviewOptions& options,
              std::ostream& out);

  /// Throws Silence and Interrupted.
  void run();
  /// Prints what has been found so far.
  void report() const;
  bool all_equal() const;

 private:
  /// The trial that is being run.
  struct Trial {
    std::uint32_t recorded = 0;  ///< its number in the log
    std::uint32_t told = 0;      ///< and as the service knows it
    std::int64_t tick = -1;      ///< the last one asked
    bool over = false;           ///< no more of it is asked
    logger::SampleHeader asked;  ///< the last question's
  };

  void visit(TimedMessage& message);
  void tell_trial(TimedMessage& message, const logger::SampleHeader& header);
  void ask(TimedMessage& message, const logger::SampleHeader& header);
  void add_recorded(const TimedMessage& message, const logger::SampleHeader& header);
  void publish(TimedMessage& message) { publish(*message.channel, message.cdr); }
  void publish(const LogChannel& channel, mcap::Bytes& cdr);
  void say_words(std::uint32_t tick);
  void end_trial();

  const runtime::ServiceReport* service_report() const;
  bool is_of_trial(const logger::SampleHeader& header) const;
  void await_service();
  void await_ready();
  void await_due(std::uint64_t time_ns);
  void await_answer();
  void await_rest();
  void report(const AnswerBook& book, const std::string& topic) const;
  void listen();
  void take_answers();
  [[noreturn]] void give_up(const std::string& what) const;
  std::string last_words() const;
  void leave_trial(const std::string& why);

  InterviewOptions options_;
  std::chrono::nanoseconds patience_;
  std::optional<double> speed_;
  std::ostream& out_;
  ServiceUnderTest service_;
  Excerpt excerpt_;
  OperatorWords words_;
  Cast cast_;
  runtime::StatusBoard board_;
  ProgressLine line_;
  Pace pace_;
  AnswerBook answers_;
  std::optional<AnswerBook> activity_;
  bool has_activity_ = false;  // it publishes some
  std::optional<Trial> trial_;
  std::uint64_t asked_ = 0;
  std::uint64_t left_out_ = 0;  // questions that could not be asked
};

}  // namespace scarab::log
