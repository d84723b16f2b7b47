#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Which C++ types a configuration may hold, and how each is recognised.
namespace scarab::config {

class Check;

namespace detail {

template <class T, std::size_t N>
std::true_type is_fixed_list(const std::array<T, N>*);
template <class T, std::size_t N>
std::true_type is_fixed_list(const T (*)[N]);
std::false_type is_fixed_list(const void*);

template <class T>
std::true_type is_vector(const std::vector<T>*);
std::false_type is_vector(const void*);

template <class T>
std::true_type is_string_map(const std::map<std::string, T>*);
std::false_type is_string_map(const void*);

template <class T>
std::true_type is_optional(const std::optional<T>*);
std::false_type is_optional(const void*);

/// Stands in for a visitor where only the existence of visit_fields() is asked.
struct Probe {};

template <class X, class = void>
struct IsDescribed : std::false_type {};
template <class X>
struct IsDescribed<X,
                   std::void_t<decltype(visit_fields(std::declval<Probe&>(), std::declval<X&>()))>>
    : std::true_type {};

template <class X, class = void>
struct HasValidation : std::false_type {};
template <class X>
struct HasValidation<
    X, std::void_t<decltype(validate(std::declval<const X&>(), std::declval<const Check&>()))>>
    : std::true_type {};

}  // namespace detail

template <class T>
inline constexpr bool kIsFixedList =
    decltype(detail::is_fixed_list(static_cast<const T*>(nullptr)))::value;
template <class T>
inline constexpr bool kIsVector =
    decltype(detail::is_vector(static_cast<const T*>(nullptr)))::value;
template <class T>
inline constexpr bool kIsStringMap =
    decltype(detail::is_string_map(static_cast<const T*>(nullptr)))::value;
template <class T>
inline constexpr bool kIsOptional =
    decltype(detail::is_optional(static_cast<const T*>(nullptr)))::value;

/// A struct with a visit_fields(fields, x) in its namespace.
template <class T>
inline constexpr bool kIsDescribed = detail::IsDescribed<T>::value;

/// A type with a validate(const X&, const config::Check&) in its namespace.
template <class T>
inline constexpr bool kHasValidation = detail::HasValidation<T>::value;

/// The accepted names of an enumeration in order, from enum_names(E) in its namespace, which
/// returns a std::array<std::pair<std::string_view, E>, N>.
template <class E>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> names;
  for (const auto& entry : enum_names(E{})) names.push_back(entry.first);
  return names;
}

}  // namespace scarab::config
