#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "services/logger/core/sample_header.hpp"
#include "tools/log/sample_comparison.hpp"

namespace scarab::log {

/// The first answer that is not the recorded one.
struct OtherAnswer {
  logger::SampleHeader header;
  FieldDifference field;  ///< recorded and answered
};

/// Holds the answers of one topic against the recorded ones, in whichever order the two come. Keeps
/// only what the other side lacks yet.
class AnswerBook {
 public:
  /// The topic in the log, and as the answers are read.
  AnswerBook(const LogChannel* recorded, const LogChannel& answered, const Lenience& lenience)
      : comparison_(recorded, &answered, lenience) {}

  /// Trials are told one after the other, under their recorded numbers. What a restarted service or
  /// a replica says again counts once.
  void add_recorded(const logger::SampleHeader& header, const mcap::Bytes& cdr);
  void add_answered(const logger::SampleHeader& header, const mcap::Bytes& cdr);
  /// Nothing more comes of this trial: what has no counterpart is counted.
  void close_trial();

  /// The newest tick of the running trial that has been answered; -1: none.
  std::int64_t answered_tick() const { return answered_tick_; }
  /// Answers still missing for what was recorded in the running trial.
  bool awaits_answers() const { return !recorded_.empty(); }

  std::uint64_t equal() const { return equal_; }
  std::uint64_t different() const { return different_; }
  /// Recorded, and not answered.
  std::uint64_t unanswered() const { return unanswered_; }
  /// Answered, and not recorded: the log lacks the sample.
  std::uint64_t unrecorded() const { return unrecorded_; }
  /// All that was recorded of what was asked.
  std::uint64_t recorded() const { return equal_ + different_ + unanswered_; }
  const std::optional<OtherAnswer>& first() const { return first_; }

 private:
  struct Entry {
    logger::SampleHeader header;
    mcap::Bytes cdr;
  };
  void compare(const Entry& recorded, const Entry& answered);

  SampleComparison comparison_;
  std::map<std::int64_t, Entry> recorded_;  // by tick
  std::map<std::int64_t, Entry> answered_;
  std::int64_t compared_tick_ = -1;
  std::int64_t answered_tick_ = -1;
  std::uint64_t equal_ = 0;
  std::uint64_t different_ = 0;
  std::uint64_t unanswered_ = 0;
  std::uint64_t unrecorded_ = 0;
  std::optional<OtherAnswer> first_;
};

}  // namespace scarab::log
