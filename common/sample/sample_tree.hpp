#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "common/sample/cdr_visitor.hpp"

namespace scarab::sample {

/// A decoded sample as a tree. Its names and text are borrowed from the model and the bytes.
struct SampleNode {
  using List = std::vector<SampleNode>;
  using Struct = std::vector<std::pair<std::string_view, SampleNode>>;
  std::variant<Scalar, List, Struct> value;
};

/// Decodes a sample into a tree. Throws Error as visit_sample.
SampleNode sample_tree(const TypeModel& model, ByteView cdr);

}  // namespace scarab::sample
