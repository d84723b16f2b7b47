#include "common/sample/idl_expression.hpp"

#include <charconv>
#include <limits>
#include <string>

namespace scarab::sample {

namespace {

class Expression {
 public:
  Expression(IdlCursor& cursor, const IdlNames<std::int64_t>& constants, const IdlScope& scope)
      : cursor_(cursor), constants_(constants), scope_(scope) {}

  std::int64_t sum() {
    std::int64_t value = product();
    while (cursor_.sees("+") || cursor_.sees("-")) {
      const bool plus = cursor_.take().text == "+";
      const std::int64_t right = product();
      in_range(plus ? __builtin_add_overflow(value, right, &value)
                    : __builtin_sub_overflow(value, right, &value));
    }
    return value;
  }

 private:
  std::int64_t product() {
    std::int64_t value = factor();
    while (cursor_.sees("*") || cursor_.sees("/") || cursor_.sees("%")) {
      const char symbol = cursor_.take().text.front();
      const std::int64_t right = factor();
      if (symbol == '*') {
        in_range(__builtin_mul_overflow(value, right, &value));
        continue;
      }
      if (right == 0) cursor_.fail("a division by zero");
      in_range(right == -1 && value == std::numeric_limits<std::int64_t>::min());
      value = symbol == '/' ? value / right : value % right;
    }
    return value;
  }

  std::int64_t factor() {
    const IdlCursor::Level level(cursor_);
    if (cursor_.accept("+")) return factor();
    if (cursor_.accept("-")) {
      std::int64_t value = factor();
      in_range(__builtin_sub_overflow(std::int64_t{0}, value, &value));
      return value;
    }
    if (cursor_.accept("(")) {
      const std::int64_t value = sum();
      cursor_.expect(")");
      return value;
    }
    return cursor_.peek().kind == IdlToken::Kind::kNumber ? number() : constant();
  }

  std::int64_t constant() {
    const std::string name = cursor_.scoped_name();
    const std::int64_t* value = constants_.find(scope_, name);
    if (value == nullptr) cursor_.fail(name + " is no integer constant");
    return *value;
  }

  std::int64_t number() {
    const std::string text = cursor_.peek().text;
    const bool is_hex = text.size() > 2 && (text[1] == 'x' || text[1] == 'X');
    const bool is_octal = !is_hex && text.size() > 1 && text.front() == '0';
    const char* first = text.data() + (is_hex ? 2 : 0);
    const char* last = text.data() + text.size();
    std::int64_t value = 0;
    const auto result = std::from_chars(first, last, value, is_hex ? 16 : is_octal ? 8 : 10);
    if (result.ec != std::errc() || result.ptr != last) cursor_.fail(text + " is no integer");
    cursor_.take();
    return value;
  }

  void in_range(bool overflow) const {
    if (overflow) cursor_.fail("a number beyond 64 bits");
  }

  IdlCursor& cursor_;
  const IdlNames<std::int64_t>& constants_;
  const IdlScope& scope_;
};

}  // namespace

std::int64_t evaluate(IdlCursor& cursor, const IdlNames<std::int64_t>& constants,
                      const IdlScope& scope) {
  return Expression(cursor, constants, scope).sum();
}

}  // namespace scarab::sample
