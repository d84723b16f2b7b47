#include "tools/topic/field_list.hpp"

#include <utility>
#include <vector>

#include "common/sample/idl_text.hpp"
#include "tools/topic/text_table.hpp"

namespace scarab::topic {
namespace {

using Field = std::pair<std::string, std::string>;

std::string array_type(const sample::ArrayType& type) {
  std::string out = sample::idl_type_name(*type.element);
  for (const std::uint32_t size : type.dimensions) out += "[" + std::to_string(size) + "]";
  return out;
}

class FieldWalk {
 public:
  void walk(const sample::Type& type, const std::string& path) {
    const sample::Type& plain = sample::resolve(type);
    if (const auto* structure = std::get_if<sample::StructType>(&plain.kind)) {
      for (const sample::Member& member : structure->members) {
        walk(*member.type, path.empty() ? member.name : path + "." + member.name);
      }
    } else if (const auto* array = std::get_if<sample::ArrayType>(&plain.kind)) {
      fields.emplace_back(path, array_type(*array));
      std::string first = path;
      for (std::size_t i = 0; i < array->dimensions.size(); ++i) first += "[0]";
      walk_structs(*array->element, first);
    } else if (const auto* sequence = std::get_if<sample::SequenceType>(&plain.kind)) {
      fields.emplace_back(path, sample::idl_type_name(plain));
      fields.emplace_back(path + ".length", "number of elements");
      walk_structs(*sequence->element, path + "[0]");
    } else {
      fields.emplace_back(path, sample::idl_type_name(plain));
    }
  }

  std::vector<Field> fields;

 private:
  void walk_structs(const sample::Type& element, const std::string& path) {
    if (std::holds_alternative<sample::StructType>(sample::resolve(element).kind))
      walk(element, path);
  }
};

}  // namespace

std::string field_list(const sample::TypeModel& model, bool names_only) {
  FieldWalk walk;
  walk.walk(*model.type(), "");
  std::size_t width = 0;
  for (const auto& [path, type] : walk.fields) width = std::max(width, path.size());
  std::string out;
  for (const auto& [path, type] : walk.fields) {
    out += names_only ? path + "\n" : padded(path, width) + "  " + type + "\n";
  }
  return out;
}

}  // namespace scarab::topic
