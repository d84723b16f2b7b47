#include "tools/topic/field_list.hpp"

#include <utility>
#include <vector>

#include "common/bus/idl_text.hpp"
#include "tools/topic/text_table.hpp"

namespace scarab::topic {
namespace {

using Field = std::pair<std::string, std::string>;

std::string array_type(const bus::ArrayType& type) {
  std::string out = bus::idl_type_name(*type.element);
  for (const std::uint32_t size : type.dimensions) out += "[" + std::to_string(size) + "]";
  return out;
}

class FieldWalk {
 public:
  void walk(const bus::Type& type, const std::string& path) {
    const bus::Type& plain = bus::resolve(type);
    if (const auto* structure = std::get_if<bus::StructType>(&plain.kind)) {
      for (const bus::Member& member : structure->members) {
        walk(*member.type, path.empty() ? member.name : path + "." + member.name);
      }
    } else if (const auto* array = std::get_if<bus::ArrayType>(&plain.kind)) {
      fields.emplace_back(path, array_type(*array));
      std::string first = path;
      for (std::size_t i = 0; i < array->dimensions.size(); ++i) first += "[0]";
      walk_structs(*array->element, first);
    } else if (const auto* sequence = std::get_if<bus::SequenceType>(&plain.kind)) {
      fields.emplace_back(path, bus::idl_type_name(plain));
      fields.emplace_back(path + ".length", "number of elements");
      walk_structs(*sequence->element, path + "[0]");
    } else {
      fields.emplace_back(path, bus::idl_type_name(plain));
    }
  }

  std::vector<Field> fields;

 private:
  void walk_structs(const bus::Type& element, const std::string& path) {
    if (std::holds_alternative<bus::StructType>(bus::resolve(element).kind)) walk(element, path);
  }
};

}  // namespace

std::string field_list(const bus::TypeModel& model, bool names_only) {
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
