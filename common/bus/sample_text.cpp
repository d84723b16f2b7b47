#include "common/bus/sample_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "common/bus/quoted_text.hpp"
#include "common/bus/sample_tree.hpp"

namespace scarab::bus {

namespace {

template <class Number>
std::string number_text(Number value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

struct ScalarText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(char value) const { return character_text(value); }
  std::string operator()(std::string_view value) const { return std::string(value); }
  std::string operator()(const EnumValue& value) const {
    return value.name != nullptr ? *value.name : std::to_string(value.value);
  }
  template <class Number>
  std::string operator()(Number value) const {
    return number_text(value);
  }
};

std::string quoted(std::string_view text) {
  std::string out;
  append_quoted(out, text);
  return out;
}

/// True for what both YAML and JSON need in quotes.
bool needs_quotes(const Scalar& value) {
  if (const auto* number = std::get_if<double>(&value)) return !std::isfinite(*number);
  if (const auto* number = std::get_if<float>(&value)) return !std::isfinite(*number);
  return std::holds_alternative<std::string_view>(value) || std::holds_alternative<char>(value);
}

/// YAML's flow style, of which JSON is the form with every key and name in quotes.
std::string flow_text(const SampleNode& node, bool json) {
  if (const auto* scalar = std::get_if<Scalar>(&node.value)) {
    const bool quotes =
        needs_quotes(*scalar) || (json && std::holds_alternative<EnumValue>(*scalar));
    return quotes ? quoted(scalar_text(*scalar)) : scalar_text(*scalar);
  }
  std::string out;
  if (const auto* list = std::get_if<SampleNode::List>(&node.value)) {
    for (const SampleNode& element : *list) {
      out += (out.empty() ? "" : ", ") + flow_text(element, json);
    }
    return "[" + out + "]";
  }
  for (const auto& [name, member] : std::get<SampleNode::Struct>(node.value)) {
    out += (out.empty() ? "" : ", ") + (json ? quoted(name) : std::string(name)) + ": ";
    out += flow_text(member, json);
  }
  return "{" + out + "}";
}

bool has_structs(const SampleNode& node) {
  if (std::holds_alternative<SampleNode::Struct>(node.value)) return true;
  const auto* list = std::get_if<SampleNode::List>(&node.value);
  return list != nullptr && std::any_of(list->begin(), list->end(), has_structs);
}

/// The lines of a struct or of a list with structs in it.
std::string block_text(const SampleNode& node, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string out;
  if (const auto* list = std::get_if<SampleNode::List>(&node.value)) {
    for (const SampleNode& element : *list) {
      out += margin + "- " + block_text(element, indent + 2).substr(indent + 2);
    }
    return out;
  }
  for (const auto& [name, member] : std::get<SampleNode::Struct>(node.value)) {
    out += margin + std::string(name) + ":";
    out += has_structs(member) ? "\n" + block_text(member, indent + 2)
                               : " " + flow_text(member, false) + "\n";
  }
  return out;
}

}  // namespace

std::string scalar_text(const Scalar& value) { return std::visit(ScalarText{}, value); }

std::string yaml_text(const TypeModel& model, ByteView cdr) {
  return block_text(sample_tree(model, cdr), 0);
}

std::string json_text(const TypeModel& model, ByteView cdr) {
  return flow_text(sample_tree(model, cdr), true);
}

}  // namespace scarab::bus
