#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scarab::sample {

/// A word of IDL text (OMG IDL 4.2, 7.2).
struct IdlToken {
  enum class Kind {
    kWord,     ///< identifier or keyword
    kNumber,   ///< as it stands: 12, 0x1F, 1.5e3
    kLiteral,  ///< a string or character, quotes included
    kSymbol,   ///< one character, or ::
    kEnd,
  };

  Kind kind = Kind::kEnd;
  std::string text;
  std::size_t line = 1;
};

/// Splits IDL text; comments and preprocessor lines are left out, the last token is kEnd. Throws
/// Error `line N: ...` for what is no token and for comments and literals without end.
std::vector<IdlToken> idl_tokens(std::string_view idl);

}  // namespace scarab::sample
