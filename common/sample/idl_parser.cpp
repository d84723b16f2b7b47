#include "common/sample/idl_parser.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "common/sample/error.hpp"
#include "common/sample/idl_annotations.hpp"
#include "common/sample/idl_expression.hpp"
#include "common/sample/idl_type_spec.hpp"

namespace scarab::sample {

namespace {

// Beyond what any program has: refused, so that no text makes a tree that is too deep for the
// recursions over it, or one that doubles with every line.
constexpr std::size_t kMostLevels = 64;
constexpr std::size_t kMostLeaves = 100'000;

class Parser {
 public:
  explicit Parser(const std::string& idl) : cursor_(idl) {}

  TypeModel run(const std::string& type_name) {
    while (!cursor_.is_end()) definition();
    const IdlType* found = declared_.types.find_full(type_name);
    if (found == nullptr) throw Error("no type " + type_name + " in the IDL text");
    return TypeModel(found->type);
  }

 private:
  void definition();
  void module();
  void constant();
  void struct_definition(const IdlAnnotations& annotations);
  void base(StructType& out, IdlType& size);
  void member(StructType& out, IdlType& size);
  void enum_definition(const IdlAnnotations& annotations);
  void literal(EnumType& out, std::int64_t& next);
  void type_definition();

  void declare(const std::string& full_name, IdlType type);
  [[noreturn]] void unsupported(const std::string& what) const {
    cursor_.fail(what + " not supported");
  }

  IdlCursor cursor_;
  IdlDeclarations declared_;
};

void Parser::definition() {
  const IdlAnnotations annotations = parse_annotations(cursor_, declared_);
  if (cursor_.accept("module")) {
    module();
  } else if (cursor_.accept("const")) {
    constant();
  } else if (cursor_.accept("struct")) {
    struct_definition(annotations);
  } else if (cursor_.accept("enum")) {
    enum_definition(annotations);
  } else if (cursor_.accept("typedef")) {
    type_definition();
  } else {
    for (const char* kind : {"union", "bitmask", "bitset", "interface", "valuetype"}) {
      if (cursor_.sees(kind)) unsupported(kind);
    }
    if (!cursor_.sees(";")) cursor_.fail("expected a declaration, found " + cursor_.seen());
  }
  cursor_.expect(";");
}

void Parser::module() {
  const IdlCursor::Level level(cursor_);
  const IdlScope outside = declared_.scope;
  declared_.scope += cursor_.identifier() + "::";
  cursor_.expect("{");
  while (!cursor_.accept("}")) {
    if (cursor_.is_end()) cursor_.fail("'{' without '}'");
    definition();
  }
  declared_.scope = outside;
}

void Parser::constant() {
  if (!parse_whole_number_type(cursor_)) {
    // No bound can be made of it.
    while (!cursor_.sees(";") && !cursor_.is_end()) cursor_.take();
    return;
  }
  const std::string name = declared_.scope + cursor_.identifier();
  cursor_.expect("=");
  const std::int64_t value = evaluate(cursor_, declared_.constants, declared_.scope);
  if (!declared_.constants.declare(name, value)) cursor_.fail(name + " is declared twice");
}

void Parser::struct_definition(const IdlAnnotations& annotations) {
  StructType out{declared_.scope + cursor_.identifier(), {}, annotations.extensibility};
  if (cursor_.sees(";")) return;  // a forward declaration
  if (annotations.is_mutable) unsupported("mutable struct " + out.name);
  IdlType size{nullptr, 0, 0};
  if (cursor_.accept(":")) base(out, size);
  cursor_.expect("{");
  while (!cursor_.accept("}")) member(out, size);
  if (out.members.empty()) cursor_.fail("struct " + out.name + " without members");
  const std::string name = out.name;
  declare(name, wrap(size, std::move(out)));
}

/// On the wire the members of a base are just the first ones.
void Parser::base(StructType& out, IdlType& size) {
  const std::string name = cursor_.scoped_name();
  const IdlType* found = declared_.types.find(declared_.scope, name);
  const auto* structure =
      found == nullptr ? nullptr : std::get_if<StructType>(&resolve(*found->type).kind);
  if (structure == nullptr) cursor_.fail(name + " is no struct");
  out.members = structure->members;
  size = *found;
}

void Parser::member(StructType& out, IdlType& size) {
  const IdlAnnotations annotations = parse_annotations(cursor_, declared_);
  if (annotations.optional) unsupported("optional member of " + out.name);
  const IdlType type = parse_type_spec(cursor_, declared_);
  do {
    const std::string name = cursor_.identifier();
    const IdlType whole = parse_dimensions(cursor_, declared_, type);
    const auto same = [&](const Member& other) { return other.name == name; };
    if (std::any_of(out.members.begin(), out.members.end(), same)) {
      cursor_.fail(out.name + "." + name + " is declared twice");
    }
    out.members.push_back({name, whole.type, annotations.key});
    size.levels = std::max(size.levels, whole.levels);
    size.leaves += whole.leaves;
  } while (cursor_.accept(","));
  cursor_.expect(";");
}

void Parser::enum_definition(const IdlAnnotations& annotations) {
  EnumType out{declared_.scope + cursor_.identifier(), {}};
  if (annotations.bit_bound > 32 || annotations.bit_bound <= 16) {
    unsupported("enum " + out.name + " of " + std::to_string(annotations.bit_bound) + " bits");
  }
  cursor_.expect("{");
  std::int64_t next = 0;
  do {
    literal(out, next);
  } while (cursor_.accept(","));
  cursor_.expect("}");
  const std::string name = out.name;
  declare(name, {make_type(std::move(out))});
}

void Parser::literal(EnumType& out, std::int64_t& next) {
  const std::int64_t value = parse_annotations(cursor_, declared_).value.value_or(next);
  using Limits = std::numeric_limits<std::int32_t>;
  if (value < Limits::min() || value > Limits::max()) {
    cursor_.fail("a value of " + out.name + " beyond 32 bits");
  }
  out.literals.push_back({cursor_.identifier(), static_cast<std::int32_t>(value)});
  next = value + 1;
}

void Parser::type_definition() {
  parse_annotations(cursor_, declared_);
  const IdlType type = parse_type_spec(cursor_, declared_);
  do {
    const std::string name = declared_.scope + cursor_.identifier();
    const IdlType whole = parse_dimensions(cursor_, declared_, type);
    declare(name, wrap(whole, AliasType{name, whole.type}));
  } while (cursor_.accept(","));
}

void Parser::declare(const std::string& full_name, IdlType type) {
  if (type.levels > kMostLevels) cursor_.fail(full_name + " is nested too deep");
  if (type.leaves > kMostLeaves) cursor_.fail(full_name + " has too many members");
  if (!declared_.types.declare(full_name, std::move(type))) {
    cursor_.fail(full_name + " is declared twice");
  }
}

}  // namespace

TypeModel parse_idl(const std::string& idl, const std::string& type_name) {
  return Parser(idl).run(type_name);
}

}  // namespace scarab::sample
