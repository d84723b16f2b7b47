#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "common/config/json.hpp"
#include "common/config/range.hpp"
#include "common/config/traits.hpp"

namespace scarab::experiment {

/// Writes values as one JSON object on one line; a visitor of described structs, too.
class RowWriter {
 public:
  template <class T>
  void operator()(std::string_view key, const T& value, const config::Range& /*range*/ = {}) {
    if (!members_.empty()) members_ += ", ";
    members_ += config::in_json_quotes(key) + ": " + text_of(value);
  }
  /// Leaves out what is not there.
  template <class T>
  void optional(std::string_view key, const std::optional<T>& value) {
    if (value) (*this)(key, *value);
  }

  [[nodiscard]] std::string text() const { return "{" + members_ + "}"; }

 private:
  template <class T>
  static std::string text_of(const std::optional<T>& value) {
    return value ? text_of(*value) : "null";
  }
  template <class T>
  static std::string text_of(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      for (const auto& [name, named] : enum_names(T{})) {
        if (named == value) return config::in_json_quotes(name);
      }
      return "null";
    } else if constexpr (std::is_arithmetic_v<T>) {
      return fmt::format("{}", value);  // the shortest text that reads back to the same number
    } else {
      return config::in_json_quotes(value);
    }
  }

  std::string members_;
};

}  // namespace scarab::experiment
