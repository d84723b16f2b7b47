#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <fastrtps/utils/fixed_size_string.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tests/interop/fastdds/enum_names.hpp"
#include "tests/interop/fastdds/sample_members.hpp"

/// Samples as one line of JSON, in the form of `scarab-log cat --json`: numbers with as many digits
/// as bring the same number back, enums by name.
namespace scarab::fastdds {

std::string quoted_text(std::string_view text);

template <class Number>
std::string number_text(Number value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  const std::string text(buffer.data(), end);
  return std::isfinite(static_cast<double>(value)) ? text : quoted_text(text);
}

template <class Enum>
std::string enum_text(Enum value) {
  constexpr auto kNames = names_of(Enum{});
  const auto index = static_cast<std::size_t>(value);
  return quoted_text(index < kNames.size() ? kNames[index] : std::to_string(index));
}

template <class T>
std::string json_text(const T& value);

template <class List>
std::string list_text(const List& list) {
  std::string out;
  for (const auto& element : list) out += (out.empty() ? "" : ", ") + json_text(element);
  return "[" + out + "]";
}

template <class Struct>
std::string struct_text(const Struct& value) {
  std::string out;
  for_each_member(value, [&](const char* name, const auto& member) {
    out += (out.empty() ? "" : ", ") + quoted_text(name) + ": " + json_text(member);
  });
  return "{" + out + "}";
}

/// What a value is written as, by the kind of its C++ type.
template <class T>
struct JsonText {
  static std::string of(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      return value ? "true" : "false";
    } else if constexpr (std::is_enum_v<T>) {
      return enum_text(value);
    } else if constexpr (std::is_arithmetic_v<T>) {
      return number_text(value);
    } else {
      return struct_text(value);
    }
  }
};
template <>
struct JsonText<std::string> {
  static std::string of(const std::string& value) { return quoted_text(value); }
};
template <std::size_t Size>
struct JsonText<eprosima::fastrtps::fixed_string<Size>> {
  static std::string of(const eprosima::fastrtps::fixed_string<Size>& value) {
    return quoted_text(value.c_str());
  }
};
template <class T, std::size_t Size>
struct JsonText<std::array<T, Size>> {
  static std::string of(const std::array<T, Size>& value) { return list_text(value); }
};
template <class T>
struct JsonText<std::vector<T>> {
  static std::string of(const std::vector<T>& value) { return list_text(value); }
};

template <class T>
std::string json_text(const T& value) {
  return JsonText<T>::of(value);
}

}  // namespace scarab::fastdds
