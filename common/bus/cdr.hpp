#pragma once

#include <utility>

#include "common/bus/raw_cdr.hpp"
#include "common/bus/topic.hpp"

namespace scarab::bus {

/// A sample that owns its strings and sequences.
template <class T>
class Owned {
 public:
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  Owned(Owned&& other) noexcept : sample_(std::exchange(other.sample_, T{})) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(sample_, other.sample_);
    return *this;
  }
  ~Owned() { dds_sample_free(&sample_, &descriptor<T>(), DDS_FREE_CONTENTS); }

  T& operator*() { return sample_; }
  const T& operator*() const { return sample_; }
  T* operator->() { return &sample_; }
  const T* operator->() const { return &sample_; }

 private:
  T sample_{};
};

/// The bytes of a sample as a type-less reader takes them; see encode_sample.
template <class T>
Bytes encode(const T& sample) {
  return encode_sample(descriptor<T>(), &sample);
}

/// The sample of such bytes. Throws Error for bytes that are no T.
template <class T>
Owned<T> decode(ByteView cdr) {
  Owned<T> out;
  decode_sample(descriptor<T>(), cdr, &*out);
  return out;
}

}  // namespace scarab::bus
