#pragma once

#include <string>
#include <vector>

#include "common/sample/field_path.hpp"
#include "common/sample/sample_tree.hpp"

namespace scarab::sample {

/// Appends a sample as one line of JSON: what json_text returns. Throws Error as visit_sample.
void append_json(std::string& out, const TypeModel& type, ByteView cdr);

/// Appends a part of a sample in the same form.
void append_json(std::string& out, const SampleNode& part);

/// Appends the part of a sample that a path leads to; null where a sequence is shorter.
void append_field(std::string& out, const FieldPath& field, const SampleNode& sample);

/// Appends `"field": part` for each of them, between commas.
void append_fields(std::string& out, const std::vector<FieldPath>& fields,
                   const SampleNode& sample);

/// Appends a value as it stands in a table: what scalar_text returns.
void append_plain(std::string& out, const Scalar& value);

}  // namespace scarab::sample
