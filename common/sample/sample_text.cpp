#include "common/sample/sample_text.hpp"

#include <algorithm>
#include <cmath>

#include "common/sample/quoted_text.hpp"
#include "common/sample/sample_json.hpp"
#include "common/sample/sample_tree.hpp"

namespace scarab::sample {

namespace {

std::string quoted(std::string_view text) {
  std::string out;
  append_quoted(out, text);
  return out;
}

/// True for what YAML needs in quotes, or would take for something else.
bool needs_quotes(const Scalar& value) {
  if (const auto* number = std::get_if<double>(&value)) return !std::isfinite(*number);
  if (const auto* number = std::get_if<float>(&value)) return !std::isfinite(*number);
  return std::holds_alternative<std::string_view>(value) || std::holds_alternative<char>(value);
}

/// YAML's flow style: JSON without quotes where YAML needs none.
std::string flow_text(const SampleNode& node) {
  if (const auto* scalar = std::get_if<Scalar>(&node.value)) {
    return needs_quotes(*scalar) ? quoted(scalar_text(*scalar)) : scalar_text(*scalar);
  }
  std::string out;
  if (const auto* list = std::get_if<SampleNode::List>(&node.value)) {
    for (const SampleNode& element : *list) {
      out += (out.empty() ? "" : ", ") + flow_text(element);
    }
    return "[" + out + "]";
  }
  for (const auto& [name, member] : std::get<SampleNode::Struct>(node.value)) {
    out += (out.empty() ? "" : ", ") + std::string(name) + ": " + flow_text(member);
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
                               : " " + flow_text(member) + "\n";
  }
  return out;
}

}  // namespace

std::string scalar_text(const Scalar& value) {
  std::string out;
  append_plain(out, value);
  return out;
}

std::string yaml_text(const TypeModel& model, ByteView cdr) {
  return block_text(sample_tree(model, cdr), 0);
}

std::string json_text(const TypeModel& model, ByteView cdr) {
  std::string out;
  append_json(out, model, cdr);
  return out;
}

}  // namespace scarab::sample
