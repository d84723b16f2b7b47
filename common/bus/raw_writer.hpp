#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "common/bus/dynamic_sample.hpp"
#include "common/bus/endpoint.hpp"
#include "common/bus/raw_cdr.hpp"
#include "common/bus/raw_qos.hpp"
#include "common/bus/topic_type.hpp"

namespace scarab::bus {

/// Writes any topic from bytes, without knowing its type at compile time. Each sample is decoded
/// and encoded again on its way, so that nothing that is no sample of the type gets out, and every
/// representation it is recorded in goes out in the one the QoS names.
class RawWriter : public WriterEndpoint {
 public:
  /// Throws Error naming the topic and the cause.
  RawWriter(Participant& participant, const std::string& topic, TopicType type, const RawQos& qos);

  /// Hands a sample (encapsulation header first) to every matched reader, stamped with the time of
  /// the call. Throws Error, before anything is sent, for bytes that are no sample of the type, and
  /// when readers do not acknowledge for 1 s.
  void write(ByteView cdr);
  /// The same with the source time stamp `source_ns`, ns since the Unix epoch.
  void write(ByteView cdr, std::int64_t source_ns);

  /// Waits until every matched reliable reader has acknowledged all that was written; false after
  /// `limit`.
  bool await_acknowledged(std::chrono::nanoseconds limit) const;

 private:
  DynamicSample decoded(ByteView cdr) const;

  TopicType type_;
};

}  // namespace scarab::bus
