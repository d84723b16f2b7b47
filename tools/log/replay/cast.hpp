#pragma once

#include <map>
#include <memory>
#include <vector>

#include "common/bus/discovery.hpp"
#include "tools/log/replay/answer_reader.hpp"
#include "tools/log/replay/service_under_test.hpp"
#include "tools/log/replay/session.hpp"
#include "tools/log/replay/topic_writer.hpp"

namespace scarab::log {

/// The parts that a replay plays around a service: a participant for each, so that the service
/// finds the peers it expects, with the writers that each had in the log and readers of the
/// answers.
class Cast {
 public:
  /// `expect`: whose parts are played; none: of everybody who wrote a topic of the log, and a
  /// logger's. `topics`: what is written, by nobody else in the domain unless `force`. Throws
  /// std::runtime_error, bus::Error.
  Cast(const Log& log, const std::set<std::string>& topics, const ServiceUnderTest& service,
       const runtime::Expectation& expect, const runtime::BusOptions& bus, bool force);

  /// The participant that waits, and reads the answers that count.
  Session& session() { return *session_; }
  AnswerReader& answers() { return *readers_.front(); }
  /// Null where the service has none.
  AnswerReader* activity() { return activity_; }

  /// Null for a channel that is not played.
  TopicWriter* writer(const LogChannel& channel);

  /// Topics that cannot be published, and why.
  const std::vector<std::string>& left_out() const { return left_out_; }

  /// What is not matched yet of what the service writes, has to read, and reads beside, as
  /// `supervisor/0 to read scarab/robot_state`.
  std::vector<std::string> unmatched();
  /// Waits until the service has all that was written; false after `limit`.
  bool flush(std::chrono::nanoseconds limit);

 private:
  bus::Participant& participant_of(const bus::Peer& peer);
  void add_writer(const LogChannel& channel);

  ServiceUnderTest service_;
  runtime::BusOptions bus_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<bus::Discovery> discovery_;
  std::map<bus::Peer, std::unique_ptr<bus::Participant>> others_;
  std::vector<std::unique_ptr<AnswerReader>> readers_;  // the session's answers first
  AnswerReader* activity_ = nullptr;
  std::vector<std::unique_ptr<TopicWriter>> writers_;
  std::map<const LogChannel*, TopicWriter*> of_channel_;
  std::vector<std::string> left_out_;
};

}  // namespace scarab::log
