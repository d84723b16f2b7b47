#include "tools/log/replay/interviewer.hpp"

#include "common/bus/clock.hpp"
#include "tools/log/replay/header_edit.hpp"
#include "tools/log/words.hpp"

namespace scarab::log {
namespace {

constexpr const char* kTrial = "scarab/trial";
constexpr const char* kOperator = "scarab/operator";

/// Throws std::invalid_argument where the log lacks what it takes to ask the service.
ServiceUnderTest checked(const Log& log, const ServiceUnderTest& service) {
  for (const std::string& topic : {std::string(kTrial), service.question, service.answer}) {
    require_topic(log, topic);
  }
  return service;
}

/// All of the log but what services say of themselves.
ReplayOptions of_the_robot(const Log& log, ReplayOptions options) {
  if (log.find("scarab/service_status") != nullptr) options.except.insert("scarab/service_status");
  return options;
}

/// What the service is to hear: nothing of its own.
std::set<std::string> topics_for(const Excerpt& excerpt, const ServiceUnderTest& service) {
  std::set<std::string> topics = excerpt.topics();
  topics.erase(service.answer);
  topics.erase(service.activity);
  return topics;
}

AnswerBook book(const Log& log, const AnswerReader& reader, const std::string& topic,
                const Lenience& lenience) {
  return {log.find(topic), reader.channel(), lenience};
}

}  // namespace

Interviewer::Interviewer(const Log& log, const ReplayOptions& replay,
                         const InterviewOptions& options, std::ostream& out)
    : patience_(std::chrono::duration_cast<std::chrono::nanoseconds>(replay.patience)),
      speed_(replay.speed),
      out_(out),
      service_(checked(log, service_under_test(options.service, options.instance))),
      excerpt_(log, of_the_robot(log, replay)),
      words_(log, service_.peer),
      cast_(log, topics_for(excerpt_, service_), service_, options.expect, replay.bus,
            replay.force),
      board_(cast_.session().participant()),
      line_("asking " + bus::to_string(service_.peer)),
      pace_(replay.speed),
      answers_(book(log, cast_.answers(), service_.answer, options.lenience)) {
  if (cast_.activity() != nullptr && log.find(service_.activity) != nullptr) {
    activity_ = book(log, *cast_.activity(), service_.activity, options.lenience);
  }
  cast_.session().wait_set().attach(board_.reader());
  for (const std::string& reason : cast_.left_out()) out_ << "left out: " << reason << '\n';
}

void Interviewer::run() {
  excerpt_.for_each([this](TimedMessage& message) {
    visit(message);
    return true;
  });
  end_trial();
  if (asked_ == 0) {
    throw Silence("nothing could be asked: the log has no trial from its " + std::string(kTrial) +
                  " and first tick on");
  }
}

void Interviewer::visit(TimedMessage& message) {
  const std::string& topic = message.channel->topic;
  logger::SampleHeader header;
  if (message.channel->has_header) {
    const auto read = logger::read_sample_header(message.cdr.data(), message.cdr.size());
    if (!read) throw mcap::FormatError(topic + ": a sample without the header of its type");
    header = *read;
  }
  if (topic == kTrial) {
    tell_trial(message, header);
  } else if (topic == service_.question) {
    ask(message, header);
  } else if (service_.writes(topic)) {
    add_recorded(message, header);
  } else if (topic == kOperator && words_.knows(header.stamp_ns)) {
    return;  // it comes before the tick from which on it counted
  } else if (header.trial == 0 || is_of_trial(header)) {
    publish(message);
  }
}

bool Interviewer::is_of_trial(const logger::SampleHeader& header) const {
  return trial_ && header.trial == trial_->recorded && !trial_->over;
}

/// A trial told again to a recorder that came late is no new one.
void Interviewer::tell_trial(TimedMessage& message, const logger::SampleHeader& header) {
  if (trial_ && trial_->recorded == header.trial) return;
  end_trial();
  await_service();
  trial_.emplace();
  trial_->recorded = header.trial;
  trial_->told = std::max(header.trial, service_report()->ready_trial + 1);
  pace_.start(message.time_ns, Session::Clock::now());
  publish(message);
  await_ready();
}

void Interviewer::ask(TimedMessage& message, const logger::SampleHeader& header) {
  if (!is_of_trial(header)) {
    ++left_out_;
    return;
  }
  const std::int64_t tick = header.tick;
  if (tick <= trial_->tick) return;
  if (tick != trial_->tick + 1) {
    ++left_out_;
    leave_trial("the log lacks tick " + std::to_string(trial_->tick + 1));
    return;
  }
  if (tick == 0) pace_.start(message.time_ns, Session::Clock::now());
  await_due(message.time_ns);
  trial_->tick = tick;
  say_words(header.tick);
  publish(message);
  ++asked_;
  line_.say("trial " + std::to_string(header.trial) + ", tick " + std::to_string(tick));
  if (!speed_) await_answer();
}

void Interviewer::add_recorded(const TimedMessage& message, const logger::SampleHeader& header) {
  if (!trial_ || header.trial != trial_->recorded) return;
  if (trial_->over && static_cast<std::int64_t>(header.tick) > trial_->tick) return;
  if (message.channel->topic == service_.answer) {
    answers_.add_recorded(header, message.cdr);
  } else if (activity_) {
    activity_->add_recorded(header, message.cdr);
  }
}

/// As if it came from the robot now, in the trial as the service knows it.
void Interviewer::publish(const LogChannel& channel, mcap::Bytes& cdr) {
  TopicWriter* writer = cast_.writer(channel);
  if (writer == nullptr) return;
  if (channel.has_header) {
    const auto header = logger::read_sample_header(cdr.data(), cdr.size());
    if (trial_ && header->trial == trial_->recorded) set_trial(cdr, trial_->told);
    set_stamp(cdr, bus::now_ns());
  }
  writer->write(cdr);
}

/// What a person said, so that it counts from this tick on: it is there before the tick is asked.
void Interviewer::say_words(std::uint32_t tick) {
  for (const OperatorWords::Word& word : words_.counting_from(trial_->recorded, tick)) {
    mcap::Bytes cdr = word.cdr;
    publish(*word.channel, cdr);
    if (TopicWriter* writer = cast_.writer(*word.channel)) writer->flush(patience_);
  }
}

/// The service's answers depend on all questions before: none of the trial can be compared any
/// more.
void Interviewer::leave_trial(const std::string& why) {
  trial_->over = true;
  out_ << "trial " << trial_->recorded << " is left: " << why
       << ", and what follows depends on it\n";
}

void Interviewer::end_trial() {
  if (!trial_) return;
  await_rest();
  out_ << "trial " << trial_->recorded << ": "
       << counted(static_cast<std::uint64_t>(trial_->tick + 1), "tick") << " asked";
  if (trial_->told != trial_->recorded) out_ << " (as trial " << trial_->told << ")";
  out_ << '\n';
  answers_.close_trial();
  if (activity_) activity_->close_trial();
  trial_.reset();
}

void Interviewer::report(const AnswerBook& book, const std::string& topic) const {
  const std::string name = short_name(topic);
  if (book.first()) {
    const logger::SampleHeader& header = book.first()->header;
    const FieldDifference& field = book.first()->field;
    constexpr double kNsPerS = 1e9;
    out_ << "first other " << name << ": trial " << header.trial << ", tick " << header.tick << " ("
         << static_cast<double>(header.sim_time_ns) / kNsPerS << " s): " << field.field
         << ": recorded " << field.a << ", answered " << field.b << '\n';
  }
  out_ << name << ": " << book.equal() << " of " << counted(book.recorded(), "answer") << " equal";
  if (book.unanswered() > 0) out_ << ", " << book.unanswered() << " missing";
  if (book.unrecorded() > 0) out_ << "; the log lacks " << book.unrecorded() << " more";
  out_ << '\n';
}

void Interviewer::report() const {
  if (asked_ == 0) return;
  if (left_out_ > 0) {
    out_ << counted(left_out_, "tick") << " of trials that the log does not have from the start\n";
  }
  report(answers_, service_.answer);
  if (activity_ && has_activity_) report(*activity_, service_.activity);
  if (activity_ && !has_activity_) {
    out_ << short_name(service_.activity) << ": " << bus::to_string(service_.peer)
         << " publishes none\n";
  }
}

bool Interviewer::all_equal() const {
  const auto is_equal = [](const AnswerBook& book) {
    return book.different() == 0 && book.unanswered() == 0;
  };
  return answers_.equal() > 0 && is_equal(answers_) &&
         (!activity_ || !has_activity_ || is_equal(*activity_));
}

}  // namespace scarab::log
