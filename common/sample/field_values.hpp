#pragma once

#include <optional>
#include <vector>

#include "common/sample/cdr_visitor.hpp"
#include "common/sample/field_path.hpp"

namespace scarab::sample {

/// Reads single values out of samples without decoding them into a tree.
class FieldValues {
 public:
  /// Throws Error for a path that is not one value.
  FieldValues(TypeModel model, std::vector<FieldPath> paths);

  /// The values of a sample, one a path; nothing where a sequence is shorter. Text is borrowed from
  /// the bytes. Throws Error as visit_sample.
  std::vector<std::optional<Scalar>> read(ByteView cdr) const;

 private:
  TypeModel model_;
  std::vector<FieldPath> paths_;
};

}  // namespace scarab::sample
