#pragma once

#include <cstddef>
#include <cstdint>

#include "common/sample/idl_names.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::sample {

/// A type of an IDL text, and how large a tree it is.
struct IdlType {
  TypeRef type;
  std::size_t levels = 1;  ///< of types within types
  std::size_t leaves = 1;  ///< members and elements that are no types of their own
};

inline TypeRef make_type(decltype(Type::kind) kind) {
  return std::make_shared<const Type>(Type{std::move(kind)});
}

/// `inner` inside of one more type.
inline IdlType wrap(const IdlType& inner, decltype(Type::kind) kind) {
  return {make_type(std::move(kind)), inner.levels + 1, inner.leaves};
}

/// What an IDL text has declared so far, and where it stands.
struct IdlDeclarations {
  IdlNames<IdlType> types;
  IdlNames<std::int64_t> constants;
  IdlScope scope;
};

}  // namespace scarab::sample
