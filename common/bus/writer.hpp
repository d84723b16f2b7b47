#pragma once

#include "common/bus/endpoint.hpp"
#include "common/bus/topic.hpp"

namespace scarab::bus {

/// Writes samples of one topic with its profile. Thread-safe.
template <class T>
class Writer : public CheckedWriter {
 public:
  Writer(Participant& participant, const Topic<T>& topic)
      : CheckedWriter(participant, topic.name, descriptor<T>(), topic.profile) {}

  /// Hands a sample to every matched reader. Throws Error, before anything is sent, for a sample
  /// that is none of the type (a value that its enum does not have, a bounded string without end, a
  /// sequence beyond its bound), and when readers do not acknowledge for 1 s.
  void write(const T& sample) { write_sample(&sample); }

  /// The same for a sample that may wait for flush(), or for the next write(): in a participant
  /// that gathers samples many leave in one packet, in others each at once.
  void stage(const T& sample) { stage_sample(&sample); }

  /// Says that the instance with this sample's key is no more.
  void dispose(const T& sample) { dispose_sample(&sample); }
};

}  // namespace scarab::bus
