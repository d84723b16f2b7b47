#pragma once

#include <string>

#include "common/bus/topic_type.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::test {

/// A sample of any compiled topic type in which every leaf has a value that is not its default and,
/// as far as its type has that many, no other leaf's; sequences have two elements. Written straight
/// into the C struct, so that it owes nothing to the code that reads samples.
class FilledSample {
 public:
  explicit FilledSample(const dds_topic_descriptor_t& type);
  FilledSample(const FilledSample&) = delete;
  FilledSample& operator=(const FilledSample&) = delete;
  ~FilledSample();

  const void* get() const { return memory_; }
  /// What is in it, as one line of JSON.
  const std::string& json() const { return json_; }

 private:
  const dds_topic_descriptor_t& type_;
  void* memory_;
  std::string json_;
};

}  // namespace scarab::test
