#include "common/sample/sample_columns.hpp"

#include <algorithm>

#include "common/sample/error.hpp"
#include "common/sample/sample_text.hpp"
#include "common/sample/sample_tree.hpp"

namespace scarab::sample {

namespace {

// No table has that many; a type in a foreign log may have.
constexpr std::size_t kMostColumns = 1'000'000;

/// Walks the type and, where there is one, the sample beside it, so that names and values cannot
/// diverge.
class Flattening {
 public:
  Flattening(const ColumnOptions& options, std::vector<std::string>* names,
             std::vector<std::string>* values)
      : options_(options), names_(names), values_(values) {}

  void walk(const Type& type, const SampleNode* node, const std::string& path) {
    if (const auto* alias = std::get_if<AliasType>(&type.kind)) {
      walk(*alias->target, node, path);
    } else if (const auto* structure = std::get_if<StructType>(&type.kind)) {
      walk_struct(*structure, node, path);
    } else if (const auto* array = std::get_if<ArrayType>(&type.kind)) {
      walk_array(*array, 0, node, path);
    } else if (const auto* sequence = std::get_if<SequenceType>(&type.kind)) {
      walk_sequence(*sequence, node, path);
    } else {
      column(path, node == nullptr ? "" : scalar_text(std::get<Scalar>(node->value)));
    }
  }

 private:
  void column(const std::string& name, std::string value) {
    if (++columns_ > kMostColumns) throw Error("too many columns: more than a million");
    if (names_ != nullptr) names_->push_back(name);
    if (values_ != nullptr) values_->push_back(std::move(value));
  }

  void walk_struct(const StructType& type, const SampleNode* node, const std::string& path) {
    const auto* members = node == nullptr ? nullptr : &std::get<SampleNode::Struct>(node->value);
    for (std::size_t i = 0; i < type.members.size(); ++i) {
      const Member& member = type.members[i];
      walk(*member.type, members == nullptr ? nullptr : &(*members)[i].second,
           path.empty() ? member.name : path + "." + member.name);
    }
  }

  void walk_array(const ArrayType& type, std::size_t depth, const SampleNode* node,
                  const std::string& path) {
    if (depth == type.dimensions.size()) return walk(*type.element, node, path);
    for (std::size_t i = 0; i < type.dimensions[depth]; ++i) {
      walk_array(type, depth + 1, element(node, i), path + "[" + std::to_string(i) + "]");
    }
  }

  void walk_sequence(const SequenceType& type, const SampleNode* node, const std::string& path) {
    column(path + ".length",
           node == nullptr ? "" : std::to_string(std::get<SampleNode::List>(node->value).size()));
    std::size_t shown = options_.sequence_elements;
    if (type.bound != 0) shown = std::min<std::size_t>(shown, type.bound);
    for (std::size_t i = 0; i < shown; ++i) {
      walk(*type.element, element(node, i), path + "[" + std::to_string(i) + "]");
    }
  }

  static const SampleNode* element(const SampleNode* node, std::size_t i) {
    if (node == nullptr) return nullptr;
    const auto& list = std::get<SampleNode::List>(node->value);
    return i < list.size() ? &list[i] : nullptr;
  }

  ColumnOptions options_;
  std::size_t columns_ = 0;
  std::vector<std::string>* names_;
  std::vector<std::string>* values_;
};

}  // namespace

std::vector<std::string> column_names(const TypeModel& model, const ColumnOptions& options) {
  std::vector<std::string> names;
  Flattening(options, &names, nullptr).walk(*model.type(), nullptr, "");
  return names;
}

std::vector<std::string> column_values(const TypeModel& model, ByteView cdr,
                                       const ColumnOptions& options) {
  std::vector<std::string> values;
  const SampleNode tree = sample_tree(model, cdr);
  Flattening(options, nullptr, &values).walk(*model.type(), &tree, "");
  return values;
}

}  // namespace scarab::sample
