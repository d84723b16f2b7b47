#pragma once

#include <dds/dds.h>

#include <cstddef>
#include <string>
#include <vector>

#include "common/sample/type_model.hpp"

namespace scarab::bus {

/// What Cyclone leaves to the writer: it sends unterminated bounded strings, leaks memory at a bad
/// enum value, and sends the padding of plain structs as it happens to be.
class SampleCheck {
 public:
  /// Throws Error when the C struct of the type is not what its type information says.
  explicit SampleCheck(const dds_topic_descriptor_t& descriptor);

  /// Throws Error naming the member and what is wrong with it: `mode: 9 is no scarab::Mode`,
  /// `reason: text without end`, `contacts: 97 elements, at most 96`.
  void check(const void* sample) const;

  /// The sample with every byte between its members zero, so that equal samples are equal bytes:
  /// `sample` itself if it has no such bytes, else a copy in `buffer`. What pointers point to is
  /// shared.
  const void* without_padding(const void* sample, std::vector<std::byte>& buffer) const;

 private:
  /// Something to check in a struct: a member, at some depth, or a list whose elements have
  /// something.
  struct Field {
    enum class Kind { kBoolean, kEnum, kText, kSequence, kArray };
    Kind kind;
    std::string name;        ///< its path from the struct
    std::size_t offset = 0;  ///< from the start of the struct
    std::size_t bound = 0;   ///< kText: characters; kSequence: elements, 0: any; kArray: elements
    std::size_t stride = 0;  ///< of a list: bytes of an element
    sample::TypeRef type;    ///< of an enum
    std::vector<Field> element;  ///< of a list: what to check in each element
  };

  static std::vector<Field> fields_of(const sample::TypeRef& type, std::size_t offset,
                                      const std::string& name);
  static std::vector<Field> fields_of_struct(const sample::StructType& type, std::size_t offset,
                                             const std::string& name);
  static std::vector<Field> fields_of_list(const sample::Type& type, std::size_t offset,
                                           const std::string& name);
  static void check_all(const std::vector<Field>& fields, const std::byte* base);
  static void check_one(const Field& field, const std::byte* base);
  static void check_list(const Field& field, const std::byte* first, std::size_t count);

  /// Bytes of the struct, from begin to before end.
  struct Range {
    std::size_t begin;
    std::size_t end;
  };

  std::size_t size_ = 0;
  std::vector<Field> fields_;
  std::vector<Range> padding_;
};

}  // namespace scarab::bus
