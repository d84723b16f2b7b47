#include "common/bus/idl_parser.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "common/bus/error.hpp"
#include "common/bus/idl_cursor.hpp"
#include "common/bus/idl_expression.hpp"
#include "common/bus/idl_names.hpp"

namespace scarab::bus {

namespace {

// Beyond what any program has: refused, so that no text makes a tree that is too deep for the
// recursions over it, or one that doubles with every line.
constexpr std::size_t kMostLevels = 64;
constexpr std::size_t kMostLeaves = 100'000;

/// A type, and how large a tree it is.
struct Parsed {
  TypeRef type;
  std::size_t levels = 1;
  std::size_t leaves = 1;
};

/// What the annotations before a declaration say, as far as it changes the bytes.
struct Annotations {
  bool key = false;
  bool optional = false;
  bool is_mutable = false;
  Extensibility extensibility = Extensibility::kFinal;
  std::optional<std::int64_t> value;
  std::int64_t bit_bound = 32;
};

TypeRef make(decltype(Type::kind) kind) {
  return std::make_shared<const Type>(Type{std::move(kind)});
}

/// `type` inside of one more type.
Parsed wrap(const Parsed& type, decltype(Type::kind) kind) {
  return {make(std::move(kind)), type.levels + 1, type.leaves};
}

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

bool is_whole_number(Primitive primitive) {
  return primitive != Primitive::kBoolean && primitive != Primitive::kChar &&
         primitive != Primitive::kFloat && primitive != Primitive::kDouble;
}

class Parser {
 public:
  explicit Parser(const std::string& idl) : cursor_(idl) {}

  TypeModel run(const std::string& type_name) {
    while (!cursor_.is_end()) definition();
    const Parsed* found = types_.find_full(type_name);
    if (found == nullptr) throw Error("no type " + type_name + " in the IDL text");
    return TypeModel(found->type);
  }

 private:
  void definition();
  void module();
  void constant();
  void struct_definition(const Annotations& annotations);
  void enum_definition(const Annotations& annotations);
  void type_definition();

  Annotations annotations();
  void annotation(Annotations& out);
  /// An annotation's one parameter, with or without its name.
  std::int64_t parameter();

  void base(StructType& out, Parsed& size);
  void member(StructType& out, Parsed& size);
  Parsed type_spec();
  Parsed string_type();
  Parsed sequence_type();
  /// The type of a declarator: its array dimensions around the type before it.
  Parsed dimensions(const Parsed& type);

  std::string primitive_name();
  std::int64_t evaluate_here() { return evaluate(cursor_, constants_, scope_); }
  std::uint32_t bound();
  void declare(const std::string& name, Parsed type);
  [[noreturn]] void unsupported(const std::string& what) const {
    cursor_.fail(what + " not supported");
  }

  IdlCursor cursor_;
  IdlScope scope_;
  IdlNames<Parsed> types_;
  IdlNames<std::int64_t> constants_;
};

void Parser::definition() {
  const Annotations found = annotations();
  if (cursor_.accept("module")) {
    module();
  } else if (cursor_.accept("const")) {
    constant();
  } else if (cursor_.accept("struct")) {
    struct_definition(found);
  } else if (cursor_.accept("enum")) {
    enum_definition(found);
  } else if (cursor_.accept("typedef")) {
    type_definition();
  } else {
    for (const char* kind : {"union", "bitmask", "bitset", "interface", "valuetype"}) {
      if (cursor_.sees(kind)) unsupported(kind);
    }
    if (!cursor_.accept(";")) cursor_.fail("expected a declaration, found " + cursor_.seen());
    return;
  }
  cursor_.expect(";");
}

void Parser::module() {
  const IdlCursor::Level level(cursor_);
  const IdlScope outside = scope_;
  scope_ += cursor_.identifier() + "::";
  cursor_.expect("{");
  while (!cursor_.accept("}")) {
    if (cursor_.is_end()) cursor_.fail("'{' without '}'");
    definition();
  }
  scope_ = outside;
}

void Parser::constant() {
  const auto primitive = primitive_of(primitive_name());
  if (primitive && is_whole_number(*primitive)) {
    const std::string name = cursor_.identifier();
    cursor_.expect("=");
    if (!constants_.declare(scope_ + name, evaluate_here())) {
      cursor_.fail(name + " is declared twice");
    }
    return;
  }
  // Of another type: no bound can be made of it.
  while (!cursor_.sees(";") && !cursor_.is_end()) cursor_.take();
}

void Parser::struct_definition(const Annotations& annotations) {
  StructType out{scope_ + cursor_.identifier(), {}, annotations.extensibility};
  if (cursor_.sees(";")) return;  // a forward declaration
  if (annotations.is_mutable) unsupported("mutable struct " + out.name);
  Parsed size{nullptr, 0, 0};
  if (cursor_.accept(":")) base(out, size);
  cursor_.expect("{");
  while (!cursor_.accept("}")) member(out, size);
  if (out.members.empty()) cursor_.fail("struct " + out.name + " without members");
  const std::string name = out.name;
  declare(name, wrap(size, std::move(out)));
}

/// On the wire the members of a base are just the first ones.
void Parser::base(StructType& out, Parsed& size) {
  const std::string name = cursor_.scoped_name();
  const Parsed* found = types_.find(scope_, name);
  const auto* structure =
      found == nullptr ? nullptr : std::get_if<StructType>(&resolve(*found->type).kind);
  if (structure == nullptr) cursor_.fail(name + " is no struct");
  out.members = structure->members;
  size = *found;
}

void Parser::member(StructType& out, Parsed& size) {
  const Annotations found = annotations();
  if (found.optional) unsupported("optional member of " + out.name);
  const Parsed type = type_spec();
  do {
    const std::string name = cursor_.identifier();
    const Parsed whole = dimensions(type);
    const auto same = [&](const Member& other) { return other.name == name; };
    if (std::any_of(out.members.begin(), out.members.end(), same)) {
      cursor_.fail(out.name + "." + name + " is declared twice");
    }
    out.members.push_back({name, whole.type, found.key});
    size.levels = std::max(size.levels, whole.levels);
    size.leaves += whole.leaves;
  } while (cursor_.accept(","));
  cursor_.expect(";");
}

void Parser::enum_definition(const Annotations& annotations) {
  EnumType out{scope_ + cursor_.identifier(), {}};
  if (annotations.bit_bound > 32 || annotations.bit_bound <= 16) {
    unsupported("enum " + out.name + " of other than 32 bits");
  }
  cursor_.expect("{");
  std::int64_t next = 0;
  do {
    const std::int64_t value = this->annotations().value.value_or(next);
    using Limits = std::numeric_limits<std::int32_t>;
    if (value < Limits::min() || value > Limits::max()) {
      cursor_.fail("a value of " + out.name + " beyond 32 bits");
    }
    out.literals.push_back({cursor_.identifier(), static_cast<std::int32_t>(value)});
    next = value + 1;
  } while (cursor_.accept(","));
  cursor_.expect("}");
  const std::string name = out.name;
  declare(name, {make(std::move(out))});
}

void Parser::type_definition() {
  annotations();
  const Parsed type = type_spec();
  do {
    const std::string name = scope_ + cursor_.identifier();
    const Parsed whole = dimensions(type);
    declare(name, wrap(whole, AliasType{name, whole.type}));
  } while (cursor_.accept(","));
}

Annotations Parser::annotations() {
  Annotations out;
  while (cursor_.accept("@")) annotation(out);
  return out;
}

void Parser::annotation(Annotations& out) {
  if (cursor_.sees("annotation")) unsupported("a declaration of annotations");
  const std::string name = cursor_.scoped_name();
  if (name == "final") out.extensibility = Extensibility::kFinal;
  if (name == "appendable") out.extensibility = Extensibility::kAppendable;
  if (name == "mutable") out.is_mutable = true;
  const bool has_parameters = cursor_.accept("(");
  if (name == "key" || name == "optional") {
    const bool is_off = has_parameters && (cursor_.sees("FALSE") || cursor_.sees("false"));
    (name == "key" ? out.key : out.optional) = !is_off;
  }
  if (!has_parameters) return;
  if (name == "value") out.value = parameter();
  if (name == "bit_bound") out.bit_bound = parameter();
  if (name == "extensibility") {
    if (cursor_.sees("APPENDABLE")) out.extensibility = Extensibility::kAppendable;
    if (cursor_.sees("MUTABLE")) out.is_mutable = true;
  }
  cursor_.skip_group("(", ")");
}

std::int64_t Parser::parameter() {
  if (cursor_.accept("value")) cursor_.expect("=");
  return evaluate_here();
}

/// The words of a primitive type joined, or one other word; nothing is taken of other tokens.
std::string Parser::primitive_name() {
  if (cursor_.peek().kind != IdlToken::Kind::kWord) return {};
  std::string name = cursor_.take().text;
  if (name == "unsigned") name += " " + cursor_.identifier();
  if (name == "long" && cursor_.accept("double")) unsupported("long double");
  if ((name == "long" || name == "unsigned long") && cursor_.accept("long")) name += " long";
  return name;
}

Parsed Parser::type_spec() {
  const IdlCursor::Level level(cursor_);
  if (cursor_.accept("sequence")) return sequence_type();
  if (cursor_.accept("string")) return string_type();
  for (const char* kind : {"wstring", "wchar", "map", "any", "fixed", "struct", "union", "enum"}) {
    if (cursor_.sees(kind)) unsupported(std::string(kind) + " in this place");
  }
  const bool is_primitive = cursor_.sees("unsigned") || primitive_of(cursor_.peek().text);
  if (is_primitive) {
    const std::string name = primitive_name();
    const auto primitive = primitive_of(name);
    if (!primitive) cursor_.fail("no type " + name);
    return {make(*primitive)};
  }
  const std::string name = cursor_.scoped_name();
  const Parsed* found = types_.find(scope_, name);
  if (found == nullptr) cursor_.fail("type " + name + " is not declared");
  return *found;
}

Parsed Parser::string_type() {
  StringType out;
  if (cursor_.accept("<")) {
    out.bound = bound();
    cursor_.expect(">");
  }
  return {make(out)};
}

Parsed Parser::sequence_type() {
  cursor_.expect("<");
  const Parsed element = type_spec();
  const std::uint32_t most = cursor_.accept(",") ? bound() : 0;
  cursor_.expect(">");
  return wrap(element, SequenceType{element.type, most});
}

Parsed Parser::dimensions(const Parsed& type) {
  std::vector<std::uint32_t> sizes;
  while (cursor_.accept("[")) {
    sizes.push_back(bound());
    cursor_.expect("]");
  }
  if (sizes.empty()) return type;
  if (sizes.size() > kMostLevels) cursor_.fail("an array of too many dimensions");
  return wrap(type, ArrayType{type.type, std::move(sizes)});
}

std::uint32_t Parser::bound() {
  const std::int64_t value = evaluate_here();
  if (value < 1 || value > std::numeric_limits<std::uint32_t>::max()) {
    cursor_.fail(std::to_string(value) + " is no size");
  }
  return static_cast<std::uint32_t>(value);
}

void Parser::declare(const std::string& name, Parsed type) {
  if (type.levels > kMostLevels) cursor_.fail(name + " is nested too deep");
  if (type.leaves > kMostLeaves) cursor_.fail(name + " has too many members");
  if (!types_.declare(name, std::move(type))) cursor_.fail(name + " is declared twice");
}

}  // namespace

TypeModel parse_idl(const std::string& idl, const std::string& type_name) {
  return Parser(idl).run(type_name);
}

}  // namespace scarab::bus
