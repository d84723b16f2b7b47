#include <algorithm>

#include "common/runtime/peers.hpp"
#include "tools/log/replay/header_edit.hpp"
#include "tools/log/replay/interviewer.hpp"
#include "tools/log/words.hpp"

// What an interviewer waits for: the service itself, its readiness, its answers, the clock.
namespace scarab::log {
namespace {

using Clock = Session::Clock;

constexpr std::chrono::milliseconds kPoll{5};          // while matches are looked for
constexpr std::chrono::milliseconds kSamplePoll{200};  // while samples wake us

}  // namespace

const runtime::ServiceReport* Interviewer::service_report() const {
  return board_.find(service_.peer);
}

/// What the service says of itself, for the end of a complaint.
std::string Interviewer::last_words() const {
  const auto* report = service_report();
  if (report == nullptr) return "; nobody of that name says anything on scarab/service_status";
  return report->message.empty() ? "" : "; it says: " + report->message;
}

void Interviewer::give_up(const std::string& what) const {
  throw Silence(bus::to_string(service_.peer) + " " + what + last_words());
}

void Interviewer::await_service() {
  const auto end = Clock::now() + patience_;
  for (;;) {
    const auto missing = cast_.unmatched();
    if (missing.empty() && service_report() != nullptr) return;
    if (Clock::now() > end) {
      give_up("is not there after " +
              fixed_text(std::chrono::duration<double>(patience_).count(), 1) + " s" +
              (missing.empty() ? "" : ": still waiting for " + runtime::join(missing)) +
              " (same --domain, --tag, --interface?)");
    }
    line_.say("waits for it");
    cast_.session().wait(kPoll);
    board_.update();
    take_answers();
  }
}

void Interviewer::await_ready() {
  const auto end = Clock::now() + patience_;
  for (;;) {
    const auto* report = service_report();
    if (report != nullptr && report->ready_trial == trial_->told) return;
    if (report != nullptr && report->health == scarab_HEALTH_FAULT) {
      give_up("refuses trial " + std::to_string(trial_->recorded));
    }
    if (Clock::now() > end) {
      give_up("is not ready for trial " + std::to_string(trial_->told) + " after " +
              fixed_text(std::chrono::duration<double>(patience_).count(), 1) + " s");
    }
    listen();
  }
}

void Interviewer::await_due(std::uint64_t time_ns) {
  const auto due = pace_.due(time_ns);
  for (auto left = due - Clock::now(); speed_ && left.count() > 0; left = due - Clock::now()) {
    cast_.session().wait(left);
    board_.update();
    take_answers();
  }
}

void Interviewer::await_answer() {
  const auto since = Clock::now();
  while (answers_.answered_tick() < trial_->tick) {
    listen();
    if (answers_.answered_tick() >= trial_->tick) return;
    const auto* report = service_report();
    const bool fault = report != nullptr && report->health == scarab_HEALTH_FAULT;
    if (!fault && Clock::now() - since < patience_) continue;
    give_up(
        "has not answered tick " + std::to_string(trial_->tick) + " of trial " +
        std::to_string(trial_->recorded) + " on " + service_.answer +
        (fault ? ""
               : " for " + fixed_text(std::chrono::duration<double>(patience_).count(), 1) + " s"));
  }
}

/// At a pace answers may be on their way still; and what is published beside the last answer is in
/// any case.
void Interviewer::await_rest() {
  constexpr std::chrono::seconds kBeside{1};
  auto end = Clock::now() + patience_;
  while (answers_.awaits_answers() && answers_.answered_tick() < trial_->tick &&
         Clock::now() < end) {
    listen();
  }
  end = Clock::now() + kBeside;
  while (activity_ && has_activity_ && activity_->answered_tick() < trial_->tick &&
         Clock::now() < end) {
    listen();
  }
}

void Interviewer::listen() {
  cast_.session().wait(kSamplePoll);
  board_.update();
  take_answers();
}

void Interviewer::take_answers() {
  const auto into = [this](std::optional<AnswerBook>& book) {
    return [this, &book](logger::SampleHeader header, mcap::Bytes cdr) {
      if (!trial_ || header.trial != trial_->told || !book) return;
      set_trial(cdr, trial_->recorded);
      header.trial = trial_->recorded;
      book->add_answered(header, cdr);
    };
  };
  cast_.answers().take([this](logger::SampleHeader header, mcap::Bytes cdr) {
    if (!trial_ || header.trial != trial_->told) return;
    set_trial(cdr, trial_->recorded);
    header.trial = trial_->recorded;
    answers_.add_answered(header, cdr);
  });
  if (cast_.activity() == nullptr) return;
  cast_.activity()->take([&](const logger::SampleHeader& header, mcap::Bytes cdr) {
    has_activity_ = true;
    into(activity_)(header, std::move(cdr));
  });
}

}  // namespace scarab::log
