#include "common/sample/filter_parser.hpp"

#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "common/sample/filter_operand.hpp"
#include "common/sample/filter_tokens.hpp"
#include "common/sample/idl_text.hpp"

namespace scarab::sample {

namespace {

using Kind = FilterToken::Kind;

std::optional<FilterRelation> relation_of(const FilterToken& token) {
  static const std::map<std::string, FilterRelation> relations = {
      {"=", FilterRelation::kEqual},   {"<>", FilterRelation::kNotEqual},
      {"<", FilterRelation::kLess},    {"<=", FilterRelation::kLessOrEqual},
      {">", FilterRelation::kGreater}, {">=", FilterRelation::kGreaterOrEqual},
      {"LIKE", FilterRelation::kLike}};
  if (token.kind != Kind::kOperator && token.kind != Kind::kKeyword) return std::nullopt;
  const auto found = relations.find(token.text);
  return found == relations.end() ? std::nullopt : std::optional(found->second);
}

/// A recursive descent: OR of ANDs of NOTs of comparisons and parentheses.
class Parser {
 public:
  Parser(const TypeModel& model, const std::string& expression)
      : model_(model), tokens_(filter_tokens(expression)) {}

  ParsedFilter parse() {
    FilterCondition condition = disjunction();
    if (now().kind != Kind::kEnd) throw wrong(now(), "AND, OR or the end expected");
    return {std::move(condition), {fields_.begin(), fields_.end()}};
  }

 private:
  const FilterToken& now() const { return tokens_[at_]; }
  static Error wrong(const FilterToken& at, const std::string& reason) {
    const std::string met = at.kind == Kind::kEnd ? "the end" : at.text;
    return Error(filter_error(at.column, reason + ", but " + met + " follows"));
  }
  bool accept(Kind kind, const char* text) {
    if (now().kind != kind || now().text != text) return false;
    ++at_;
    return true;
  }

  FilterCondition joined(const char* word, FilterCondition::Kind kind,
                         FilterCondition (Parser::*part)()) {
    FilterCondition first = (this->*part)();
    if (now().kind != Kind::kKeyword || now().text != word) return first;
    FilterCondition out;
    out.kind = kind;
    out.parts.push_back(std::move(first));
    while (accept(Kind::kKeyword, word)) out.parts.push_back((this->*part)());
    return out;
  }
  FilterCondition disjunction() {
    return joined("OR", FilterCondition::Kind::kOr, &Parser::conjunction);
  }
  FilterCondition conjunction() {
    return joined("AND", FilterCondition::Kind::kAnd, &Parser::negation);
  }

  FilterCondition negation() {
    // Bounds the recursion, which every nesting goes through.
    constexpr int kDeepest = 100;
    if (++depth_ > kDeepest) throw Error(filter_error(now().column, "nested too deeply"));
    FilterCondition out;
    if (accept(Kind::kKeyword, "NOT")) {
      out.kind = FilterCondition::Kind::kNot;
      out.parts.push_back(negation());
    } else if (accept(Kind::kOperator, "(")) {
      out = disjunction();
      if (!accept(Kind::kOperator, ")")) throw wrong(now(), ") expected");
    } else {
      out = predicate();
    }
    --depth_;
    return out;
  }

  FilterCondition predicate() {
    const WrittenOperand left = operand();
    const bool negated = accept(Kind::kKeyword, "NOT");
    if (accept(Kind::kKeyword, "BETWEEN")) return between(left, negated);
    const auto relation = relation_of(now());
    if (!relation || negated) {
      throw wrong(now(),
                  negated ? "BETWEEN expected" : "one of = <> < <= > >= LIKE BETWEEN expected");
    }
    const FilterToken& sign = tokens_[at_++];
    FilterCondition out = comparison(left, *relation, operand());
    if (*relation == FilterRelation::kLike) check_like(out, left, sign);
    return out;
  }

  FilterCondition between(const WrittenOperand& field, bool negated) {
    const WrittenOperand low = operand();
    if (!accept(Kind::kKeyword, "AND")) throw wrong(now(), "AND of BETWEEN expected");
    const WrittenOperand high = operand();
    FilterCondition out;
    out.kind = negated ? FilterCondition::Kind::kOr : FilterCondition::Kind::kAnd;
    out.parts.push_back(
        comparison(field, negated ? FilterRelation::kLess : FilterRelation::kGreaterOrEqual, low));
    out.parts.push_back(
        comparison(field, negated ? FilterRelation::kGreater : FilterRelation::kLessOrEqual, high));
    return out;
  }

  static FilterCondition comparison(const WrittenOperand& left, FilterRelation relation,
                                    const WrittenOperand& right) {
    FilterCondition out;
    out.left = meant_beside(left, right);
    out.relation = relation;
    out.right = meant_beside(right, left);
    return out;
  }

  static void check_like(const FilterCondition& like, const WrittenOperand& field,
                         const FilterToken& sign) {
    const bool is_text = field.path != nullptr && !like.right.field &&
                         std::holds_alternative<std::string>(like.right.value);
    if (!is_text) {
      throw Error(filter_error(sign.column, "LIKE compares a text field with a pattern in quotes"));
    }
  }

  WrittenOperand operand() {
    const FilterToken& token = now();
    const bool is_truth =
        token.kind == Kind::kKeyword && (token.text == "TRUE" || token.text == "FALSE");
    if (token.kind == Kind::kName) return field(token);
    if (token.kind != Kind::kNumber && token.kind != Kind::kText && !is_truth) {
      throw wrong(token, "a field or a value expected");
    }
    ++at_;
    return {token, nullptr, std::nullopt};
  }

  WrittenOperand field(const FilterToken& token) {
    const std::string context = "column " + std::to_string(token.column);
    try {
      FieldPath path(model_, token.text);
      if (!path.is_scalar()) throw Error(token.text + " is not one value; name a part of it");
      fields_.push_back(std::move(path));
    } catch (const NoSuchMember& error) {
      throw NoSuchMember(context, error);
    } catch (const Error& error) {
      throw Error(context + ": " + error.what());
    }
    ++at_;
    return {token, &fields_.back(), fields_.size() - 1};
  }

  const TypeModel& model_;
  std::vector<FilterToken> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::deque<FieldPath> fields_;  // its elements stay where they are
};

}  // namespace

ParsedFilter parse_filter(const TypeModel& model, const std::string& expression) {
  return Parser(model, expression).parse();
}

}  // namespace scarab::sample
