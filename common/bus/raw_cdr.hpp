#pragma once

#include <dds/dds.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "common/sample/bytes.hpp"

/// Samples as bytes: CDR with its encapsulation header, as they are on the wire. The one place that
/// reaches below Cyclone's public API, whose serialiser it uses.
namespace scarab::bus {

using Bytes = sample::Bytes;
using ByteView = sample::ByteView;

/// A sample a type-less reader took. `cdr` is valid only during the call it is handed to.
struct RawSample {
  ByteView cdr;                   ///< 4-byte encapsulation header, then the payload
  std::int64_t source_ns = 0;     ///< wall clock of the writer, ns since the Unix epoch
  std::int64_t reception_ns = 0;  ///< wall clock of this process when it took the sample
  std::uint64_t writer = 0;       ///< the writer's instance handle
};

/// The bytes of a sample of the type: XCDR1 (for types with appendable parts, which Cyclone does
/// not write so, XCDR2), little-endian, header first, padded with zeros to a multiple of 4; byte
/// for byte what a type-less reader takes when a Writer writes the sample. Throws Error for a
/// sample that cannot be encoded (an enum value that is none).
Bytes encode_sample(const dds_topic_descriptor_t& type, const void* sample);

/// Decodes bytes of any byte order into `sample`, zeroed memory of the type's size; its strings and
/// sequences are then to be freed with dds_sample_free(.., DDS_FREE_CONTENTS). Throws Error for
/// bytes that are no sample of the type.
void decode_sample(const dds_topic_descriptor_t& type, ByteView cdr, void* sample);

/// The same for the XCDR2, little-endian bytes without header in which descriptors carry type
/// information.
void decode_xcdr2(const dds_topic_descriptor_t& type, ByteView payload, void* sample);

/// Takes all waiting samples of a reader in the order of reception and hands each with content to
/// f; returns how many.
/// Where they come faster than f takes them: no further than `enough` and what was taken with them.
std::size_t take_raw(dds_entity_t reader, const std::function<void(const RawSample&)>& f,
                     std::size_t enough = std::numeric_limits<std::size_t>::max());

}  // namespace scarab::bus
