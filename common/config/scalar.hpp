#pragma once

#include <optional>
#include <string>

/// Strict numbers: decimal only. YAML 1.1's octal `010`, hexadecimal, `1_000`, `.nan` and `.inf`
/// are refused.
namespace scarab::config {

/// A value, or the reason why there is none.
template <class T>
struct Parsed {
  std::optional<T> value;
  std::string reason;
};

[[nodiscard]] Parsed<double> parse_number(const std::string& text);
[[nodiscard]] Parsed<long long> parse_signed(const std::string& text);
[[nodiscard]] Parsed<unsigned long long> parse_unsigned(const std::string& text);

/// The shortest decimal text that parse_number() reads back to exactly `value`, which must be
/// finite.
[[nodiscard]] std::string format_number(double value);

}  // namespace scarab::config
