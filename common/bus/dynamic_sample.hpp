#pragma once

#include "common/bus/raw_cdr.hpp"
#include "common/bus/topic_type.hpp"

namespace scarab::bus {

/// A sample of a type that is known at run time only, in the C struct Cyclone lays out for it; owns
/// its strings and sequences.
class DynamicSample {
 public:
  /// Decodes CDR (header first). Throws Error as decode_sample.
  DynamicSample(TopicType type, ByteView cdr);
  DynamicSample(const DynamicSample&) = delete;
  DynamicSample& operator=(const DynamicSample&) = delete;
  ~DynamicSample();

  const void* get() const { return memory_; }

 private:
  TopicType type_;
  void* memory_;
};

}  // namespace scarab::bus
