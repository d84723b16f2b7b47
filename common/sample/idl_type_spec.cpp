#include "common/sample/idl_type_spec.hpp"

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/sample/idl_expression.hpp"

namespace scarab::sample {

namespace {

constexpr std::size_t kMostDimensions = 64;

std::optional<Primitive> primitive_of(const std::string& name) {
  static const std::map<std::string, Primitive> kinds{
      {"boolean", Primitive::kBoolean}, {"octet", Primitive::kOctet},
      {"uint8", Primitive::kOctet},     {"int8", Primitive::kInt8},
      {"char", Primitive::kChar},       {"short", Primitive::kInt16},
      {"int16", Primitive::kInt16},     {"unsigned short", Primitive::kUint16},
      {"uint16", Primitive::kUint16},   {"long", Primitive::kInt32},
      {"int32", Primitive::kInt32},     {"unsigned long", Primitive::kUint32},
      {"uint32", Primitive::kUint32},   {"long long", Primitive::kInt64},
      {"int64", Primitive::kInt64},     {"unsigned long long", Primitive::kUint64},
      {"uint64", Primitive::kUint64},   {"float", Primitive::kFloat},
      {"double", Primitive::kDouble}};
  const auto found = kinds.find(name);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

/// One word, or the several of a primitive type.
std::string type_words(IdlCursor& cursor) {
  std::string name = cursor.identifier();
  if (name == "unsigned") name += " " + cursor.identifier();
  if (name == "long" && cursor.sees("double")) cursor.fail("long double not supported");
  if ((name == "long" || name == "unsigned long") && cursor.accept("long")) name += " long";
  return name;
}

std::uint32_t bound(IdlCursor& cursor, const IdlDeclarations& declared) {
  const std::int64_t value = evaluate(cursor, declared.constants, declared.scope);
  if (value < 1 || value > std::numeric_limits<std::uint32_t>::max()) {
    cursor.fail(std::to_string(value) + " is no size");
  }
  return static_cast<std::uint32_t>(value);
}

IdlType string_type(IdlCursor& cursor, const IdlDeclarations& declared) {
  StringType out;
  if (cursor.accept("<")) {
    out.bound = bound(cursor, declared);
    cursor.expect(">");
  }
  return {make_type(out)};
}

IdlType sequence_type(IdlCursor& cursor, const IdlDeclarations& declared) {
  cursor.expect("<");
  const IdlType element = parse_type_spec(cursor, declared);
  const std::uint32_t most = cursor.accept(",") ? bound(cursor, declared) : 0;
  cursor.expect(">");
  return wrap(element, SequenceType{element.type, most});
}

}  // namespace

IdlType parse_type_spec(IdlCursor& cursor, const IdlDeclarations& declared) {
  const IdlCursor::Level level(cursor);
  if (cursor.accept("sequence")) return sequence_type(cursor, declared);
  if (cursor.accept("string")) return string_type(cursor, declared);
  for (const char* kind : {"wstring", "wchar", "map", "any", "fixed", "struct", "union", "enum"}) {
    if (cursor.sees(kind)) cursor.fail(std::string(kind) + " in this place not supported");
  }
  if (cursor.sees("unsigned") || primitive_of(cursor.peek().text)) {
    const std::string name = type_words(cursor);
    const auto primitive = primitive_of(name);
    if (!primitive) cursor.fail("no type " + name);
    return {make_type(*primitive)};
  }
  const std::string name = cursor.scoped_name();
  const IdlType* found = declared.types.find(declared.scope, name);
  if (found == nullptr) cursor.fail("type " + name + " is not declared");
  return *found;
}

IdlType parse_dimensions(IdlCursor& cursor, const IdlDeclarations& declared, const IdlType& type) {
  std::vector<std::uint32_t> sizes;
  while (cursor.accept("[")) {
    sizes.push_back(bound(cursor, declared));
    cursor.expect("]");
  }
  if (sizes.empty()) return type;
  if (sizes.size() > kMostDimensions) cursor.fail("an array of too many dimensions");
  return wrap(type, ArrayType{type.type, std::move(sizes)});
}

bool parse_whole_number_type(IdlCursor& cursor) {
  const auto primitive = primitive_of(type_words(cursor));
  return primitive && *primitive != Primitive::kBoolean && *primitive != Primitive::kChar &&
         *primitive != Primitive::kFloat && *primitive != Primitive::kDouble;
}

}  // namespace scarab::sample
