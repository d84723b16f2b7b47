#pragma once

#include "tools/log/replay/options.hpp"
#include "tools/log/replay/time_order.hpp"

namespace scarab::log {

/// The part of a log that is to be published again.
class Excerpt {
 public:
  /// Throws std::invalid_argument for topics that the log does not have. `log` must outlive this.
  Excerpt(const Log& log, const ReplayOptions& options);

  const Log& log() const { return log_; }
  const std::set<std::string>& topics() const { return topics_; }
  /// Leaves a topic out.
  void drop(const std::string& topic) { topics_.erase(topic); }
  /// Its first and last moment, ns since the Unix epoch.
  std::uint64_t begin_ns() const { return begin_ns_; }
  std::uint64_t end_ns() const { return end_ns_; }

  /// Visits its messages in the order of publication, up to where `visit` says false.
  void for_each(const TimeOrder::Visitor& visit) const;

 private:
  bool has(const TimedMessage& message) const;

  const Log& log_;
  std::set<std::string> topics_;
  std::optional<std::uint32_t> trial_;
  bool from_the_start_ = true;
  std::uint64_t begin_ns_ = 0;
  std::uint64_t end_ns_ = 0;
};

}  // namespace scarab::log
