#pragma once

#include <dds/dds.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/entity.hpp"

namespace scarab::bus {

/// What of a writer's QoS decides which readers match it and what they get: enough to publish a
/// recorded topic again as it was.
struct RawQos {
  dds_reliability_kind_t reliability = DDS_RELIABILITY_RELIABLE;
  dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;  ///< or transient-local
  dds_ownership_kind_t ownership = DDS_OWNERSHIP_SHARED;
  std::int32_t ownership_strength = 0;
  dds_liveliness_kind_t liveliness = DDS_LIVELINESS_AUTOMATIC;
  std::optional<std::chrono::nanoseconds> liveliness_lease;  ///< nothing: infinite
  std::optional<std::chrono::nanoseconds> deadline;          ///< nothing: infinite
  int history_depth = 64;  ///< samples kept of each instance; 0: all
  /// Samples of each instance kept for late joiners, once all readers there are have them; nothing:
  /// as many as the history.
  std::optional<int> late_joiner_depth;
  std::vector<std::string> partitions;  ///< none: the default partition
  bool xcdr2 = false;                   ///< data representation: XCDR2, not XCDR1
};
bool operator==(const RawQos& a, const RawQos& b);

/// The policies of an announced writer. Writers do not announce their history: it is
/// `history_depth`'s default. Kinds of durability beyond transient-local count as that.
RawQos raw_qos_of(const dds_qos_t& announced);

/// The same as words, for the metadata of a log: `reliability: reliable`, `partition.0: left`. What
/// is at its default and has no word for that (partitions, lease, deadline) is left out.
std::map<std::string, std::string> to_words(const RawQos& qos);

/// Words that are absent mean the default; unknown ones are passed over. Throws Error naming the
/// word for a value that none of to_words() is.
RawQos raw_qos_from_words(const std::map<std::string, std::string>& words);

/// The policies for a DDS entity. A dead writer unregisters its instances instead of disposing of
/// them.
Qos dds_qos_of(const RawQos& qos);

}  // namespace scarab::bus
