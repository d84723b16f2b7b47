#pragma once

#include <string>
#include <vector>

#include "common/bus/peer.hpp"
#include "tools/log/log.hpp"

namespace scarab::log {

/// A service of the chain that can be run against a log: what it is asked, and what it answers.
struct ServiceUnderTest {
  bus::Peer peer;
  std::string question;  ///< the topic whose tick k it answers
  std::string answer;    ///< the topic of its answer k: there is one to each question
  std::string activity;  ///< what it may publish beside, once a tick; empty: nothing

  bool writes(const std::string& topic) const {
    return topic == answer || (!activity.empty() && topic == activity);
  }
};

/// Throws std::invalid_argument for another name than supervisor or premotor.
ServiceUnderTest service_under_test(const std::string& name, std::uint32_t instance);

/// Who wrote a channel: the first of the writers it names, else who writes the topic in a stack.
bus::Peer writer_of(const LogChannel& channel);

/// `behaviour` of `scarab/behaviour`.
std::string short_name(const std::string& topic);

}  // namespace scarab::log
