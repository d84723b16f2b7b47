#include "tools/log/replay/answer_book.hpp"

#include <algorithm>

namespace scarab::log {

void AnswerBook::add_recorded(const logger::SampleHeader& header, const mcap::Bytes& cdr) {
  const std::int64_t tick = header.tick;
  if (tick <= compared_tick_) return;
  const auto answered = answered_.find(tick);
  if (answered == answered_.end()) {
    recorded_.try_emplace(tick, Entry{header, cdr});
    return;
  }
  compare({header, cdr}, answered->second);
  answered_.erase(answered);
}

void AnswerBook::add_answered(const logger::SampleHeader& header, const mcap::Bytes& cdr) {
  const std::int64_t tick = header.tick;
  if (tick <= answered_tick_) return;
  answered_tick_ = tick;
  const auto recorded = recorded_.find(tick);
  if (recorded == recorded_.end()) {
    answered_.try_emplace(tick, Entry{header, cdr});
    return;
  }
  compare(recorded->second, {header, cdr});
  recorded_.erase(recorded);
}

void AnswerBook::compare(const Entry& recorded, const Entry& answered) {
  compared_tick_ = std::max<std::int64_t>(compared_tick_, recorded.header.tick);
  const auto found = comparison_.difference(recorded.cdr, answered.cdr);
  if (!found) {
    ++equal_;
    return;
  }
  ++different_;
  if (!first_) first_ = OtherAnswer{recorded.header, *found};
}

void AnswerBook::close_trial() {
  unanswered_ += recorded_.size();
  unrecorded_ += answered_.size();
  recorded_.clear();
  answered_.clear();
  compared_tick_ = answered_tick_ = -1;
}

}  // namespace scarab::log
