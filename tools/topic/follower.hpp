#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/bus/raw_reader.hpp"
#include "common/sample/type_model.hpp"
#include "tools/topic/session.hpp"

namespace scarab::topic {

/// The type of a topic, as far as it is understood.
struct FollowedType {
  explicit FollowedType(const bus::TopicType& described);

  bus::TopicType descriptor;
  std::optional<sample::TypeModel>
      model;         ///< nothing for a type with parts TypeModel does not know
  std::string text;  ///< by which types are told apart: the IDL, or why there is no model
};

/// Reads a topic from all its writers, those included that come later, each sample once.
///
/// Writers whose QoS differs have a reader of their own each, since one reader cannot ask for what
/// all of them offer (partitions, ownership, representation).
class Follower {
 public:
  using SampleHandler = std::function<void(const bus::RawSample&)>;

  /// Waits for a writer until `end`. Throws as Session::wait_for_writers and Session::type_of.
  Follower(Session& session, const std::string& topic, Clock::time_point end,
           const bus::RawReaderOptions& options = {});

  /// What it takes to decode the samples. Throws Failure (type unknown) for a type with parts that
  /// sample::TypeModel does not know; its samples can be counted all the same.
  const sample::TypeModel& model() const;
  const FollowedType& type() const { return type_; }
  /// How often the type has become another one: all writers had gone, and who came then writes a
  /// newer version.
  int type_changes() const { return type_changes_; }

  /// Waits until samples come, until `end` at most, and hands each to f; returns how many. Zero
  /// before `end`: something else happened. Says on stderr which writers cannot be followed.
  std::size_t take(Clock::time_point end, const SampleHandler& f);

 private:
  void follow_new_writers();
  void forget_all_but(const std::vector<bus::DiscoveredEndpoint>& writers);
  void follow(const bus::DiscoveredEndpoint& writer);

  Session& session_;
  std::string topic_;
  bus::RawReaderOptions options_;
  FollowedType type_;
  int type_changes_ = 0;
  std::vector<std::unique_ptr<bus::RawReader>> readers_;
  std::map<std::string, std::size_t> reader_of_qos_;
  /// Which reader brought the first sample of a writer: a second one that matches it too would
  /// bring the same samples again.
  std::map<std::uint64_t, std::size_t> reader_of_writer_;
  std::uint64_t arrivals_ = 0;    ///< of the session, as of the last look at the writers
  std::set<bus::Guid> seen_;      ///< writers looked at
  std::set<bus::Guid> followed_;  ///< those there are of the type that is read
};

}  // namespace scarab::topic
