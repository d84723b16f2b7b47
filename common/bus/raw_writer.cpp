#include "common/bus/raw_writer.hpp"

#include <utility>

#include "common/bus/clock.hpp"

namespace scarab::bus {

RawWriter::RawWriter(Participant& participant, const std::string& topic, TopicType type,
                     const RawQos& qos)
    : WriterEndpoint(participant, topic.c_str(), *type, dds_qos_of(qos)), type_(std::move(type)) {}

DynamicSample RawWriter::decoded(ByteView cdr) const {
  try {
    return {type_, cdr};
  } catch (const Error& error) {
    throw Error(name() + ": " + error.what());
  }
}

void RawWriter::write(ByteView cdr) { write(cdr, now_ns()); }

void RawWriter::write(ByteView cdr, std::int64_t source_ns) { send(decoded(cdr).get(), source_ns); }

bool RawWriter::await_acknowledged(std::chrono::nanoseconds limit) const {
  const dds_return_t code = dds_wait_for_acks(handle(), limit.count());
  if (code == DDS_RETCODE_TIMEOUT) return false;
  check(code, name());
  return true;
}

}  // namespace scarab::bus
