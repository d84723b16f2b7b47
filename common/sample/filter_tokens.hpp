#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace scarab::sample {

/// A word of a filter expression (DDS 1.4, Annex B).
struct FilterToken {
  enum class Kind {
    kName,     ///< of a field: `header.tick`
    kKeyword,  ///< AND, OR, NOT, BETWEEN, LIKE, TRUE, FALSE; in capitals whatever was written
    kNumber,
    kText,      ///< without its quotes
    kOperator,  ///< = <> < <= > >= ( )
    kEnd,
  };
  Kind kind = Kind::kEnd;
  std::string text;
  std::size_t column = 0;  ///< of its first character, from 1
};

/// The words of an expression, kEnd last. Throws Error naming the column and what is wrong there.
std::vector<FilterToken> filter_tokens(const std::string& expression);

/// `column 12: reason`, the form of every error in an expression.
std::string filter_error(std::size_t column, const std::string& reason);

}  // namespace scarab::sample
