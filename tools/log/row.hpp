#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/sample/sample_columns.hpp"

namespace scarab::log {

/// Puts samples of one type into the cells of a table, with the columns of bus::column_names(): the
/// values of bus::column_values(), without a tree in between and only where they are wanted.
class Row : private sample::SampleVisitor {
 public:
  /// `wanted`: column numbers.
  Row(const sample::TypeModel& type, const sample::ColumnOptions& options,
      const std::vector<std::size_t>& wanted);

  /// A cell for each column, filled where it is wanted; valid until the next call. Throws
  /// bus::Error as bus::visit_sample.
  const std::vector<std::string>& read(sample::ByteView cdr);

 private:
  /// The columns of a sequence.
  struct Slot {
    std::size_t shown = 0;  ///< elements that have columns
    std::size_t end = 0;    ///< the column after its last one
  };
  /// A part whose values are being visited.
  struct Open {
    bool is_sequence = false;
    Slot slot;
    std::size_t element = 0;  ///< the one that comes next
  };

  std::size_t lay_out(const sample::Type& type, std::size_t column);

  void begin_struct(const sample::StructType& type) override;
  void member(const std::string& name) override;
  void end_struct() override { leave(); }
  void begin_list(std::size_t size, bool is_sequence) override;
  void end_list() override { leave(); }
  void scalar(const sample::Scalar& value) override;

  bool passes_over();
  void leave();
  void put(const sample::Scalar& value);

  sample::TypeModel type_;
  sample::ColumnOptions options_;
  std::map<std::size_t, Slot> slots_;  ///< by first column
  std::vector<char> wanted_;
  std::vector<std::string> cells_;

  std::vector<Open> open_;
  std::size_t hidden_ = 0;  ///< open parts of an element that has no columns
  std::size_t column_ = 0;
};

}  // namespace scarab::log
