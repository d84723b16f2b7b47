#pragma once

#include <string>
#include <vector>

#include "common/bus/entity.hpp"
#include "common/bus/participant.hpp"
#include "common/bus/qos.hpp"
#include "common/bus/sample_check.hpp"

namespace scarab::bus {

/// What readers and writers have in common: a topic, a DDS entity on it, the peers it has matched
/// and the faults that keep it from matching others.
class Endpoint {
 public:
  const std::string& topic() const { return topic_; }
  dds_entity_t handle() const { return entity_.handle(); }

 protected:
  /// Throws Error naming `kind` ("reader", "writer"), the topic and the cause.
  Endpoint(Participant& participant, const char* kind, const char* topic,
           const dds_topic_descriptor_t& descriptor);

  void own(dds_entity_t entity);
  /// `writer on scarab/behaviour`: the beginning of an error message.
  std::string name() const { return kind_ + " on " + topic_; }
  dds_entity_t topic_handle() const { return topic_entity_.handle(); }

 private:
  std::string kind_;
  std::string topic_;
  Entity topic_entity_;
  Entity entity_;
};

/// What writers have in common.
class WriterEndpoint : public Endpoint {
 public:
  WriterEndpoint(Participant& participant, const char* topic,
                 const dds_topic_descriptor_t& descriptor, Qos qos);

  /// The readers that are matched at this moment, in a stable order.
  std::vector<Peer> matched() const;
  /// Why readers on this topic did not match, since the start; empty when all is well.
  std::vector<std::string> faults() const;

  /// Sends what was staged.
  void flush();

 protected:
  /// Sends a sample of the C type, stamped with `source_ns`, behind what was staged. Throws Error
  /// when readers do not acknowledge.
  void send(const void* sample, dds_time_t source_ns);
  /// The same without sending it yet, where the participant gathers samples.
  void stage(const void* sample, dds_time_t source_ns);
};

/// The untyped part of Writer<T>.
class CheckedWriter : public WriterEndpoint {
 public:
  CheckedWriter(Participant& participant, const char* topic,
                const dds_topic_descriptor_t& descriptor, Profile profile);

 protected:
  void write_sample(const void* sample);
  void stage_sample(const void* sample);
  void dispose_sample(const void* sample);

 private:
  void check(const void* sample) const;

  SampleCheck check_;
};

/// The untyped part of Reader<T>.
class ReaderEndpoint : public Endpoint {
 public:
  ReaderEndpoint(Participant& participant, const char* topic,
                 const dds_topic_descriptor_t& descriptor, Qos qos);

  /// The writers that are matched at this moment, in a stable order.
  std::vector<Peer> matched() const;
  /// Why writers on this topic did not match, and what was lost, since the start; empty when all is
  /// well.
  std::vector<std::string> faults() const;

  /// Ready as long as samples wait to be taken; what a WaitSet waits for.
  dds_entity_t condition() const { return condition_.handle(); }

 private:
  Entity condition_;
};

}  // namespace scarab::bus
