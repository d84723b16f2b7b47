#pragma once

#include <memory>
#include <string>

#include "common/sample/bytes.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::sample {

/// Selects samples by their content, with the filter expressions of the DDS standard (1.4, Annex
/// B): `header.tick > 100 AND mode = 'MODE_HARD_PUSH'`.
///
/// Fields are named as by FieldPath and must be single values. Compared by = <> < <= > >=, [NOT]
/// BETWEEN a AND b, LIKE (% any text, _ any character), joined by NOT before AND before OR, and by
/// parentheses. Text, characters and names of enum values stand in single quotes; TRUE and FALSE
/// without. A comparison with an element that a sequence does not have is false.
class SampleFilter {
 public:
  /// Throws Error: `column 15: reason`.
  SampleFilter(const TypeModel& model, const std::string& expression);
  SampleFilter(SampleFilter&&) noexcept;
  SampleFilter& operator=(SampleFilter&&) noexcept;
  ~SampleFilter();

  /// Throws Error as visit_sample for bytes that are no sample of the type.
  bool matches(ByteView cdr) const;

 private:
  class Condition;
  std::unique_ptr<const Condition> condition_;
};

}  // namespace scarab::sample
