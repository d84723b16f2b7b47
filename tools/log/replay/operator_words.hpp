#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "common/bus/peer.hpp"
#include "tools/log/log.hpp"

namespace scarab::log {

/// What a person said to a service in a log (scarab/operator), and from which tick on it counted:
/// the service has acknowledged that, as counter `operator_stamp_ns` of its status. The time stamps
/// alone do not tell where a word was on its way while a tick was being answered.
class OperatorWords {
 public:
  /// Of the supervisor, who hears words; other services hear none. Throws as mcap::Reader.
  OperatorWords(const Log& log, const bus::Peer& service);

  struct Word {
    const LogChannel* channel = nullptr;
    mcap::Bytes cdr;
  };
  /// The words that counted from this tick on, in the order in which they were said.
  const std::vector<Word>& counting_from(std::uint32_t trial, std::uint32_t tick) const;
  /// True for a word of which it is known from which tick on it counted.
  bool knows(std::int64_t stamp_ns) const { return known_.count(stamp_ns) != 0; }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Word>> words_;  // by trial, tick
  std::set<std::int64_t> known_;
};

}  // namespace scarab::log
