#include "tools/log/replay/excerpt.hpp"

#include <algorithm>
#include <cmath>

#include "services/logger/core/sample_header.hpp"

namespace scarab::log {
namespace {

constexpr double kNsPerS = 1e9;

std::uint64_t later(std::uint64_t time_ns, double by_s) {
  return time_ns + static_cast<std::uint64_t>(std::llround(std::max(by_s, 0.0) * kNsPerS));
}

}  // namespace

Excerpt::Excerpt(const Log& log, const ReplayOptions& options)
    : log_(log),
      topics_(options.topics),
      trial_(options.trial),
      from_the_start_(options.from_s <= 0) {
  for (const std::string& topic : options.topics) require_topic(log, topic);
  for (const std::string& topic : options.except) require_topic(log, topic);
  if (topics_.empty()) topics_ = log.topics();
  for (const std::string& topic : options.except) topics_.erase(topic);
  std::uint64_t first = UINT64_MAX;
  std::uint64_t last = 0;
  for (const auto& file : log.files()) {
    const mcap::Statistics& counted = file->summary().statistics;
    if (counted.message_count == 0) continue;
    first = std::min(first, counted.start_time_ns);
    last = std::max(last, counted.end_time_ns);
  }
  if (last < first) return;  // no message at all
  begin_ns_ = later(first, options.from_s);
  end_ns_ = options.to_s ? std::min(last, later(first, *options.to_s)) : last;
}

bool Excerpt::has(const TimedMessage& message) const {
  // The first messages of a log may have been published before it was opened.
  const bool too_early = !from_the_start_ && message.time_ns < begin_ns_;
  if (too_early || message.time_ns > end_ns_) return false;
  if (!trial_ || !message.channel->has_header) return true;
  const auto header = logger::read_sample_header(message.cdr.data(), message.cdr.size());
  return header && (header->trial == *trial_ || header->trial == 0);
}

void Excerpt::for_each(const TimeOrder::Visitor& visit) const {
  if (topics_.empty()) return;
  bool wanted = true;
  TimeOrder order([&](TimedMessage& message) {
    wanted = !has(message) || visit(message);
    return wanted;
  });
  log_.for_each([&](const LogChannel& channel,
                    const mcap::Message& message) { return order.push(channel, message); },
                topics_);
  if (wanted) order.flush();
}

}  // namespace scarab::log
