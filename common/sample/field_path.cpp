#include "common/sample/field_path.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include "common/sample/idl_text.hpp"

namespace scarab::sample {

namespace {

/// How many elements there can be; nothing: any number.
std::optional<std::size_t> capacity(const Type& type) {
  if (const auto* array = std::get_if<ArrayType>(&type.kind)) return array->dimensions.at(0);
  const auto& sequence = std::get<SequenceType>(type.kind);
  if (sequence.bound == 0) return std::nullopt;
  return sequence.bound;
}

bool is_list(const Type& type) {
  return std::holds_alternative<ArrayType>(type.kind) ||
         std::holds_alternative<SequenceType>(type.kind);
}

TypeRef element_type(const Type& type) {
  if (const auto* sequence = std::get_if<SequenceType>(&type.kind)) return sequence->element;
  const auto& array = std::get<ArrayType>(type.kind);
  if (array.dimensions.size() == 1) return array.element;
  return std::make_shared<const Type>(
      Type{ArrayType{array.element, {array.dimensions.begin() + 1, array.dimensions.end()}}});
}

}  // namespace

NoSuchMember::NoSuchMember(const std::string& name, const StructType& type)
    : Error([&] {
        std::string names;
        for (const Member& m : type.members) names += (names.empty() ? "" : ", ") + m.name;
        return "no member " + name + " in " + type.name + "; it has " + names;
      }()),
      name_(name) {
  for (const Member& member : type.members) known_.push_back(member.name);
}

NoSuchMember::NoSuchMember(const std::string& context, const NoSuchMember& cause)
    : Error(context + ": " + cause.what()), name_(cause.name_), known_(cause.known_) {}

FieldPath::FieldPath(const TypeModel& model, const std::string& text)
    : text_(text), type_(model.type()) {
  std::size_t at = 0;
  while (at < text.size() || at == 0) {
    if (is_length_) throw Error(text + ": nothing lies below " + parsed_);
    if (at > 0 && text[at] == '[') {
      const std::size_t end = text.find(']', at);
      if (end == std::string::npos) throw Error(text + ": [ without ]");
      enter_element(text.substr(at + 1, end - at - 1));
      at = end + 1;
    } else {
      if (at > 0 && text[at] != '.') throw Error(text + ": . or [ expected after " + parsed_);
      if (at > 0) ++at;
      const std::size_t end = std::min(text.find_first_of(".[", at), text.size());
      enter_member(text.substr(at, end - at));
      at = end;
    }
    parsed_ = text.substr(0, at);
  }
}

void FieldPath::enter_member(const std::string& name) {
  if (name.empty()) {
    throw Error(text_.empty() ? "a field without name" : text_ + ": a name is missing");
  }
  const Type& type = resolve(*type_);
  if (std::holds_alternative<SequenceType>(type.kind) && name == "length") {
    is_length_ = true;
    return;
  }
  const auto* structure = std::get_if<StructType>(&type.kind);
  if (structure == nullptr) {
    throw Error(text_ + ": " + parsed_ +
                (is_list(type) ? " is a list; its elements are " + parsed_ + "[0], ..."
                               : " is of type " + idl_type_name(type) + ", without members"));
  }
  const auto& members = structure->members;
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const Member& member) { return member.name == name; });
  if (found == members.end()) throw NoSuchMember(name, *structure);
  steps_.push_back({name, 0});
  // A copy first: the member lives in the type it replaces.
  TypeRef next = found->type;
  type_ = std::move(next);
}

void FieldPath::enter_element(const std::string& index) {
  const Type& type = resolve(*type_);
  if (!is_list(type)) throw Error(text_ + ": " + parsed_ + " is no list");
  std::size_t element = 0;
  const char* end = index.data() + index.size();
  const auto [stop, error] = std::from_chars(index.data(), end, element);
  if (error != std::errc{} || stop != end) {
    throw Error(text_ + ": '" + index + "' is no index; the first element is " + parsed_ + "[0]");
  }
  const auto most = capacity(type);
  if (most && element >= *most) {
    throw Error(text_ + ": " + parsed_ + " has " +
                (std::holds_alternative<SequenceType>(type.kind) ? "at most " : "") +
                std::to_string(*most) + " elements, [0] to [" + std::to_string(*most - 1) + "]");
  }
  steps_.push_back({"", element});
  TypeRef next = element_type(type);
  type_ = std::move(next);
}

bool FieldPath::is_scalar() const {
  const Type& type = resolve(*type_);
  return is_length_ || !(is_list(type) || std::holds_alternative<StructType>(type.kind));
}

const SampleNode* FieldPath::find(const SampleNode& sample) const {
  const SampleNode* node = &sample;
  for (const Step& step : steps_) {
    if (const auto* list = std::get_if<SampleNode::List>(&node->value)) {
      if (step.element >= list->size()) return nullptr;
      node = &(*list)[step.element];
    } else {
      const auto& members = std::get<SampleNode::Struct>(node->value);
      const auto found = std::find_if(members.begin(), members.end(), [&](const auto& member) {
        return member.first == step.member;
      });
      if (found == members.end()) return nullptr;
      node = &found->second;
    }
  }
  return node;
}

bool has_column(const std::string& field, const std::string& column) {
  if (column.compare(0, field.size(), field) != 0) return false;
  return column.size() == field.size() || column[field.size()] == '.' ||
         column[field.size()] == '[';
}

}  // namespace scarab::sample
