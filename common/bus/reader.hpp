#pragma once

#include <cstddef>
#include <cstdint>

#include "common/bus/endpoint.hpp"
#include "common/bus/loan.hpp"
#include "common/bus/topic.hpp"

namespace scarab::bus {

/// How it stands with the instance a sample belongs to, after that sample.
enum class InstanceState {
  kAlive,
  kDisposed,   ///< a writer said that it is no more
  kNoWriters,  ///< its last writer has gone or is no longer alive
};

/// What a reader knows about a sample beside its content.
struct SampleInfo {
  bool valid =
      false;  ///< false: only the key fields are set; the sample tells of a change of state
  InstanceState state = InstanceState::kAlive;
  std::int64_t source_ns = 0;  ///< wall clock of the writer, ns since the Unix epoch
};

inline SampleInfo sample_info(const dds_sample_info_t& info) {
  InstanceState state = InstanceState::kAlive;
  if (info.instance_state == DDS_NOT_ALIVE_DISPOSED_INSTANCE_STATE)
    state = InstanceState::kDisposed;
  if (info.instance_state == DDS_NOT_ALIVE_NO_WRITERS_INSTANCE_STATE) {
    state = InstanceState::kNoWriters;
  }
  return {info.valid_data, state, info.source_timestamp};
}

/// Reads samples of one topic with its profile.
template <class T>
class Reader : public ReaderEndpoint {
 public:
  Reader(Participant& participant, const Topic<T>& topic, const ReaderOptions& options = {})
      : ReaderEndpoint(participant, topic.name, descriptor<T>(),
                       reader_qos(topic.profile, options)) {}

  /// Calls f(const T&) for each waiting sample, in the order of reception; returns how many. The
  /// sample is lent: it is valid only during the call.
  template <class F>
  std::size_t take(F&& f) {
    std::size_t count = 0;
    take_with_info([&](const T& sample, const SampleInfo& info) {
      if (!info.valid) return;
      f(sample);
      ++count;
    });
    return count;
  }

  /// Calls f(const T&, const SampleInfo&) for each waiting sample and for each change of an
  /// instance's state; returns how many.
  template <class F>
  std::size_t take_with_info(F&& f) {
    std::size_t count = 0;
    while (true) {
      const Loan loan = Loan::take(handle(), name());
      for (std::size_t i = 0; i < loan.size(); ++i) {
        f(*static_cast<const T*>(loan.sample(i)), sample_info(loan.info(i)));
      }
      count += loan.size();
      if (loan.size() < Loan::kCapacity) return count;
    }
  }
};

}  // namespace scarab::bus
