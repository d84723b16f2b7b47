#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "common/runtime/options.hpp"
#include "tools/log/sample_comparison.hpp"

namespace scarab::log {

/// How a log is published again.
struct ReplayOptions {
  runtime::BusOptions bus;
  std::set<std::string> topics;        ///< none: all
  std::set<std::string> except;        ///< but these
  std::optional<std::uint32_t> trial;  ///< only samples of this trial, and those that are of none
  double from_s = 0;                   ///< since the log's first message
  std::optional<double> to_s;
  /// How many times as fast as it was recorded; nothing: as fast as it goes. Against a service:
  /// nothing, the next tick follows the answer to the last.
  std::optional<double> speed;
  bool loop = false;
  unsigned wait_readers = 0;  ///< matched readers to wait for before the first sample
  std::chrono::duration<double> patience{10};  ///< for readers, and for answers
  bool restamp = false;     ///< the wall-clock stamp in the Header of samples is that of now
  bool keep_times = false;  ///< samples keep the source time stamps of the recording
  bool force = false;       ///< also where somebody writes the topics already
};

/// Which service is run against a log, and what counts as another answer.
struct InterviewOptions {
  std::string service;  ///< supervisor or premotor
  std::uint32_t instance = 0;
  runtime::Expectation expect;  ///< whose parts are played; none: of everybody in the log
  Lenience lenience;
};

}  // namespace scarab::log
