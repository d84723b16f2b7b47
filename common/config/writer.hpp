#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "common/config/range.hpp"
#include "common/config/scalar.hpp"
#include "common/config/traits.hpp"
#include "common/config/value.hpp"

/// Writing: turns described structs into values.
namespace scarab::config {

template <class T>
[[nodiscard]] Value to_value(T& member);

/// Visitor that collects the members of a struct in a map.
class FieldWriter {
 public:
  FieldWriter() { map_.kind = Value::Kind::kMap; }

  template <class T>
  void operator()(std::string_view key, T& member, const Range& /*range*/ = kAny) {
    add(key, to_value(member));
  }
  template <class T>
  void optional(std::string_view key, T& member, const Range& /*range*/ = kAny) {
    add(key, to_value(member));
  }
  void add(std::string_view key, Value value) {
    map_.keys.push_back({std::string(key), {}});
    map_.items.push_back(std::move(value));
  }
  [[nodiscard]] Value take() { return std::move(map_); }

 private:
  Value map_;
};

namespace detail {

inline Value scalar(std::string text, bool plain) {
  Value value;
  value.kind = Value::Kind::kScalar;
  value.text = std::move(text);
  value.plain = plain;
  return value;
}

template <class E>
std::string name_of(E wanted) {
  for (const auto& [name, value] : enum_names(E{})) {
    if (value == wanted) return std::string(name);
  }
  throw std::invalid_argument("dump: an enumeration holds a value without a name");
}

}  // namespace detail

/// The value read() turns back into an equal member.
template <class T>
Value to_value(T& member) {
  if constexpr (kIsDescribed<T>) {
    FieldWriter writer;
    visit_fields(writer, member);
    return writer.take();
  } else if constexpr (kIsFixedList<T> || kIsVector<T>) {
    Value list;
    list.kind = Value::Kind::kList;
    for (auto& element : member) list.items.push_back(to_value(element));
    return list;
  } else if constexpr (kIsStringMap<T>) {
    FieldWriter writer;
    for (auto& [key, value] : member) writer.add(key, to_value(value));
    return writer.take();
  } else if constexpr (kIsOptional<T>) {
    return member ? to_value(*member) : detail::scalar("absent", true);
  } else if constexpr (std::is_enum_v<T>) {
    return detail::scalar(detail::name_of(member), true);
  } else if constexpr (std::is_same_v<T, bool>) {
    return detail::scalar(member ? "true" : "false", true);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return detail::scalar(member, false);
  } else if constexpr (std::is_same_v<T, double>) {
    return detail::scalar(format_number(member), true);
  } else {
    static_assert(std::is_integral_v<T>, "no visit_fields() or enum_names() found for this type");
    return detail::scalar(std::to_string(member), true);
  }
}

}  // namespace scarab::config
