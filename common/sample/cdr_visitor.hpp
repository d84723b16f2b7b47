#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "common/sample/bytes.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::sample {

struct EnumValue {
  std::int32_t value = 0;
  const std::string* name = nullptr;  ///< null for a value the type does not name
};

/// One value of a sample. Whole numbers of every size are widened; text is borrowed from the bytes.
using Scalar = std::variant<bool, char, std::int64_t, std::uint64_t, float, double,
                            std::string_view, EnumValue>;

/// Is told a sample's values in the order of the type.
class SampleVisitor {
 public:
  SampleVisitor() = default;
  SampleVisitor(const SampleVisitor&) = delete;
  SampleVisitor& operator=(const SampleVisitor&) = delete;
  virtual ~SampleVisitor() = default;

  virtual void begin_struct(const StructType& type) = 0;
  /// The member whose value comes next.
  virtual void member(const std::string& name) = 0;
  virtual void end_struct() = 0;
  /// An array (of each dimension, outermost first) or a sequence with so many elements.
  virtual void begin_list(std::size_t size, bool is_sequence) = 0;
  virtual void end_list() = 0;
  virtual void scalar(const Scalar& value) = 0;
};

/// Walks the CDR bytes of a sample (header first, XCDR1 or XCDR2, either byte order). Throws Error,
/// naming the type, when the bytes end early, a bound is exceeded or the representation is another.
void visit_sample(const TypeModel& model, ByteView cdr, SampleVisitor& visitor);

}  // namespace scarab::sample
