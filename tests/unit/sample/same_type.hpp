#pragma once

#include "common/sample/type_model.hpp"

namespace scarab::sample {

bool same_type(const Type& a, const Type& b);

/// Compares types in everything they say.
struct SameType {
  const Type& other;

  bool operator()(Primitive a) const { return a == get<Primitive>(); }
  bool operator()(const StringType& a) const { return a.bound == get<StringType>().bound; }
  bool operator()(const EnumType& a) const {
    const auto& b = get<EnumType>();
    if (a.name != b.name || a.literals.size() != b.literals.size()) return false;
    for (std::size_t i = 0; i < a.literals.size(); ++i) {
      if (a.literals[i].name != b.literals[i].name || a.literals[i].value != b.literals[i].value) {
        return false;
      }
    }
    return true;
  }
  bool operator()(const StructType& a) const {
    const auto& b = get<StructType>();
    if (a.name != b.name || a.extensibility != b.extensibility) return false;
    if (a.members.size() != b.members.size()) return false;
    for (std::size_t i = 0; i < a.members.size(); ++i) {
      const Member& one = a.members[i];
      const Member& two = b.members[i];
      if (one.name != two.name || one.key != two.key) return false;
      if (!same_type(*one.type, *two.type)) return false;
    }
    return true;
  }
  bool operator()(const ArrayType& a) const {
    const auto& b = get<ArrayType>();
    return a.dimensions == b.dimensions && same_type(*a.element, *b.element);
  }
  bool operator()(const SequenceType& a) const {
    const auto& b = get<SequenceType>();
    return a.bound == b.bound && same_type(*a.element, *b.element);
  }
  bool operator()(const AliasType& a) const {
    const auto& b = get<AliasType>();
    return a.name == b.name && same_type(*a.target, *b.target);
  }

 private:
  template <class T>
  const T& get() const {
    return std::get<T>(other.kind);
  }
};

inline bool same_type(const Type& a, const Type& b) {
  return a.kind.index() == b.kind.index() && std::visit(SameType{b}, a.kind);
}

}  // namespace scarab::sample
