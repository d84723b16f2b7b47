#pragma once

#include <string>
#include <string_view>

namespace scarab::sample {

/// Appends text in double quotes, as JSON and YAML both read it. What is no UTF-8 becomes U+FFFD,
/// one for each byte, and what readers do not take as it is (control characters, U+FFFE, U+FFFF) is
/// written as \uXXXX: whatever a foreign writer sends, the line stays readable.
void append_quoted(std::string& out, std::string_view text);

/// A character of IDL, which is one of ISO 8859-1, in UTF-8.
std::string character_text(char character);

}  // namespace scarab::sample
