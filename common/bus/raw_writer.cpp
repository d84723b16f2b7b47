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

void RawWriter::write(ByteView cdr, std::int64_t source_ns) {
  send(decoded(cdr).get(), source_ns);
}

}  // namespace scarab::bus
