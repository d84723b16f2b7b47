#include "common/sample/idl_annotations.hpp"

#include <string>

#include "common/sample/idl_expression.hpp"

namespace scarab::sample {

namespace {

/// An annotation's one parameter, with or without its name.
std::int64_t parameter(IdlCursor& cursor, const IdlDeclarations& declared) {
  if (cursor.accept("value")) cursor.expect("=");
  return evaluate(cursor, declared.constants, declared.scope);
}

void parse_parameters(IdlCursor& cursor, const IdlDeclarations& declared, const std::string& name,
                      IdlAnnotations& out) {
  const bool is_off = cursor.sees("FALSE") || cursor.sees("false");
  if (name == "key") out.key = !is_off;
  if (name == "optional") out.optional = !is_off;
  if (name == "value") out.value = parameter(cursor, declared);
  if (name == "bit_bound") out.bit_bound = parameter(cursor, declared);
  if (name == "extensibility") {
    if (cursor.sees("APPENDABLE")) out.extensibility = Extensibility::kAppendable;
    if (cursor.sees("MUTABLE")) out.is_mutable = true;
  }
  cursor.skip_group("(", ")");
}

void parse_annotation(IdlCursor& cursor, const IdlDeclarations& declared, IdlAnnotations& out) {
  if (cursor.sees("annotation")) cursor.fail("a declaration of annotations not supported");
  const std::string name = cursor.scoped_name();
  if (name == "appendable") out.extensibility = Extensibility::kAppendable;
  if (name == "mutable") out.is_mutable = true;
  if (name == "key") out.key = true;
  if (name == "optional") out.optional = true;
  if (cursor.accept("(")) parse_parameters(cursor, declared, name, out);
}

}  // namespace

IdlAnnotations parse_annotations(IdlCursor& cursor, const IdlDeclarations& declared) {
  IdlAnnotations out;
  while (cursor.accept("@")) parse_annotation(cursor, declared, out);
  return out;
}

}  // namespace scarab::sample
