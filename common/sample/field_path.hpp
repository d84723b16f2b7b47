#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/sample/error.hpp"
#include "common/sample/sample_tree.hpp"
#include "common/sample/type_model.hpp"

namespace scarab::sample {

/// A name that a struct does not have. what() lists the names it has; who talks to a person may
/// add which of them was meant.
class NoSuchMember : public Error {
 public:
  NoSuchMember(const std::string& name, const StructType& type);
  /// The same, met while doing something larger: `context: what()`.
  NoSuchMember(const std::string& context, const NoSuchMember& cause);

  const std::string& name() const { return name_; }
  const std::vector<std::string>& known() const { return known_; }

 private:
  std::string name_;
  std::vector<std::string> known_;
};

/// A part of the samples of a type, named as column_names() does: `header.tick`, `position_rad[3]`,
/// `contacts[0].force_n[2]`, `contacts.length`; the beginning of such a path (`header`, `contacts`)
/// is all that lies below it.
class FieldPath {
 public:
  /// A member of a struct, by name, or an element of a list.
  struct Step {
    std::string member;       ///< empty: an element
    std::size_t element = 0;  ///< from 0
  };

  /// Throws NoSuchMember for a name the type does not have, and Error naming the path and what is
  /// wrong with it otherwise: `position_rad[19]: position_rad has 19 elements, [0] to [18]`.
  FieldPath(const TypeModel& model, const std::string& text);

  const std::string& text() const { return text_; }
  const std::vector<Step>& steps() const { return steps_; }
  /// True for the number of elements of a sequence, which the steps lead to.
  bool is_length() const { return is_length_; }
  /// The type of the part; of a length, the sequence.
  const TypeRef& type() const { return type_; }
  /// True for a part that is one value: no struct, no list.
  bool is_scalar() const;

  /// The part of a sample of the type; of a length, the sequence. Null where a sequence is shorter.
  const SampleNode* find(const SampleNode& sample) const;

 private:
  void enter_member(const std::string& name);
  void enter_element(const std::string& index);

  std::string text_;
  std::string parsed_;  ///< the part of text_ that steps_ stand for
  std::vector<Step> steps_;
  TypeRef type_;
  bool is_length_ = false;
};

/// True for the columns (see column_names) that belong to a field: itself, or all that lies below.
bool has_column(const std::string& field, const std::string& column);

}  // namespace scarab::sample
