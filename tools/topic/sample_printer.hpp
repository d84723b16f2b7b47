#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/bus/raw_cdr.hpp"
#include "common/sample/field_path.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::topic {

enum class Format { kYaml, kJson, kCsv };

struct PrintOptions {
  Format format = Format::kYaml;
  std::vector<std::string> fields;  ///< paths of the parts to print; none: all
  std::size_t elements = 0;         ///< kCsv: of each sequence that get columns beside its length
};

/// Samples of one type as text: YAML documents each ended by ---, lines of JSON, or a table.
///
/// With one field, YAML and JSON are its value, a line a sample; with several, a map from paths to
/// values.
class SamplePrinter {
 public:
  /// Throws bus::NoSuchMember and bus::Error for fields the type does not have.
  SamplePrinter(const sample::TypeModel& model, const PrintOptions& options);

  /// What stands before the first sample: the names of the columns.
  const std::string& heading() const { return heading_; }

  /// Appends a sample. Throws bus::Error for bytes that are none.
  void append(sample::ByteView cdr, std::string& out) const;

 private:
  void append_fields(sample::ByteView cdr, std::string& out) const;
  /// `alone`: on a line without its name; YAML then has text as it is, without quotes.
  void append_field(const sample::FieldPath& field, const sample::SampleNode& sample, bool alone,
                    std::string& out) const;
  void append_row(sample::ByteView cdr, std::string& out) const;

  sample::TypeModel model_;
  PrintOptions options_;
  std::vector<sample::FieldPath> fields_;
  std::vector<std::size_t> columns_;  ///< kCsv: those to print, in their order
  std::string heading_;
};

}  // namespace scarab::topic
