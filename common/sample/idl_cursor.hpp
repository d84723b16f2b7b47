#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/sample/idl_lexer.hpp"

namespace scarab::sample {

/// A place in IDL text, and what a parser asks there. Every Error names the line.
class IdlCursor {
 public:
  explicit IdlCursor(const std::string& idl) : tokens_(idl_tokens(idl)) {}

  const IdlToken& peek() const { return tokens_[at_]; }
  bool is_end() const { return peek().kind == IdlToken::Kind::kEnd; }
  /// True if this word or symbol comes next.
  bool sees(const char* text) const;
  /// What comes next, in an error's words.
  std::string seen() const;

  IdlToken take();
  bool accept(const char* text);
  void expect(const char* text);
  /// A name; an escaped one (`_module`) without its underscore.
  std::string identifier();
  /// `a::b::Name`, `::a::Name` or `Name`.
  std::string scoped_name();
  /// Passes over everything up to the closing half of the pair whose opening one was just taken.
  void skip_group(const char* open, const char* close);

  [[noreturn]] void fail(const std::string& what) const;

  /// One level of a construct within itself, while the object lives: no text makes the parser's
  /// recursion run out of stack.
  class Level {
   public:
    explicit Level(IdlCursor& cursor);
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    ~Level() { --cursor_.levels_; }

   private:
    IdlCursor& cursor_;
  };

 private:
  std::vector<IdlToken> tokens_;
  std::size_t at_ = 0;
  std::size_t levels_ = 0;
};

}  // namespace scarab::sample
