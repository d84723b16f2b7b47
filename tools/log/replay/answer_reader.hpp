#pragma once

#include <functional>
#include <memory>
#include <string>

#include "common/bus/cdr.hpp"
#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "services/logger/core/sample_header.hpp"
#include "tools/log/log.hpp"

namespace scarab::log {

/// Reads the samples of a topic of the chain as bytes in one form, whoever writes them.
class AnswerReader {
 public:
  virtual ~AnswerReader() = default;
  virtual const std::string& topic() const = 0;
  virtual bus::ReaderEndpoint& endpoint() = 0;
  /// The type of the bytes, as the project has it.
  virtual const LogChannel& channel() const = 0;
  /// Hands on what waits to be taken.
  using Visitor = std::function<void(const logger::SampleHeader&, mcap::Bytes)>;
  virtual void take(const Visitor& visit) = 0;
};

/// Throws std::invalid_argument for a topic that is none of the project's.
std::unique_ptr<AnswerReader> read_answers(bus::Participant& participant, const std::string& topic);

}  // namespace scarab::log
