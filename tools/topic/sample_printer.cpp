#include "tools/topic/sample_printer.hpp"

#include <algorithm>

#include "common/config/json.hpp"
#include "common/sample/sample_columns.hpp"
#include "common/sample/sample_json.hpp"
#include "common/sample/sample_text.hpp"

namespace scarab::topic {
namespace {

/// A cell as RFC 4180 has it.
void append_cell(const std::string& value, std::string& out) {
  if (value.find_first_of(",\"\r\n") == std::string::npos) {
    out += value;
    return;
  }
  out += '"';
  for (const char c : value) out += c == '"' ? "\"\"" : std::string(1, c);
  out += '"';
}

void append_cells(const std::vector<std::string>& cells, const std::vector<std::size_t>& columns,
                  std::string& out) {
  const char* separator = "";
  for (const std::size_t column : columns) {
    out += separator;
    append_cell(cells[column], out);
    separator = ",";
  }
  out += '\n';
}

/// Enough columns of each sequence for every element that a field names.
std::size_t elements_named(const std::vector<sample::FieldPath>& fields, std::size_t at_least) {
  for (const sample::FieldPath& field : fields) {
    for (const auto& step : field.steps()) {
      if (step.member.empty()) at_least = std::max(at_least, step.element + 1);
    }
  }
  return at_least;
}

}  // namespace

SamplePrinter::SamplePrinter(const sample::TypeModel& model, const PrintOptions& options)
    : model_(model), options_(options) {
  for (const std::string& field : options.fields) fields_.emplace_back(model, field);
  if (options.format != Format::kCsv) return;
  options_.elements = elements_named(fields_, options.elements);
  const auto names = sample::column_names(model, {options_.elements});
  for (std::size_t i = 0; fields_.empty() && i < names.size(); ++i) columns_.push_back(i);
  for (const sample::FieldPath& field : fields_) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (sample::has_column(field.text(), names[i])) columns_.push_back(i);
    }
  }
  append_cells(names, columns_, heading_);
}

void SamplePrinter::append(sample::ByteView cdr, std::string& out) const {
  if (options_.format == Format::kCsv) return append_row(cdr, out);
  if (!fields_.empty()) return append_fields(cdr, out);
  if (options_.format == Format::kJson) {
    sample::append_json(out, model_, cdr);
    out += '\n';
  } else {
    out += sample::yaml_text(model_, cdr);
    out += "---\n";
  }
}

void SamplePrinter::append_fields(sample::ByteView cdr, std::string& out) const {
  const sample::SampleNode sample = sample::sample_tree(model_, cdr);
  const bool json = options_.format == Format::kJson;
  if (fields_.size() == 1) {
    append_field(fields_[0], sample, true, out);
    out += '\n';
    return;
  }
  const char* separator = "";
  if (json) out += '{';
  for (const sample::FieldPath& field : fields_) {
    out += separator;
    out += (json ? config::in_json_quotes(field.text()) : field.text()) + ": ";
    append_field(field, sample, false, out);
    separator = json ? ", " : "\n";
  }
  out += json ? "}\n" : "\n---\n";
}

void SamplePrinter::append_field(const sample::FieldPath& field, const sample::SampleNode& sample,
                                 bool alone, std::string& out) const {
  const sample::SampleNode* part = field.is_length() ? nullptr : field.find(sample);
  const sample::Scalar* scalar =
      part == nullptr ? nullptr : std::get_if<sample::Scalar>(&part->value);
  const bool is_name = scalar != nullptr && std::holds_alternative<sample::EnumValue>(*scalar);
  if (options_.format == Format::kYaml && scalar != nullptr && (alone || is_name)) {
    sample::append_plain(out, *scalar);
  } else {
    sample::append_field(out, field, sample);  // JSON is YAML's flow style
  }
}

void SamplePrinter::append_row(sample::ByteView cdr, std::string& out) const {
  append_cells(sample::column_values(model_, cdr, {options_.elements}), columns_, out);
}

}  // namespace scarab::topic
