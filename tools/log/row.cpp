#include "tools/log/row.hpp"

#include <algorithm>

#include "common/sample/sample_json.hpp"

namespace scarab::log {

Row::Row(const sample::TypeModel& type, const sample::ColumnOptions& options,
         const std::vector<std::size_t>& wanted)
    : type_(type), options_(options) {
  const std::size_t columns = lay_out(*type.type(), 0);
  cells_.resize(columns);
  wanted_.resize(columns);
  for (const std::size_t column : wanted) wanted_.at(column) = 1;
}

/// The column after those of `type`, which begin at `column`.
std::size_t Row::lay_out(const sample::Type& type, std::size_t column) {
  const sample::Type& plain = sample::resolve(type);
  if (const auto* structure = std::get_if<sample::StructType>(&plain.kind)) {
    for (const sample::Member& member : structure->members) column = lay_out(*member.type, column);
    return column;
  }
  if (const auto* array = std::get_if<sample::ArrayType>(&plain.kind)) {
    for (std::size_t i = 0; i < array->count(); ++i) column = lay_out(*array->element, column);
    return column;
  }
  const auto* sequence = std::get_if<sample::SequenceType>(&plain.kind);
  if (sequence == nullptr) return column + 1;
  Slot slot{options_.sequence_elements, column + 1};
  if (sequence->bound != 0) slot.shown = std::min<std::size_t>(slot.shown, sequence->bound);
  for (std::size_t i = 0; i < slot.shown; ++i) slot.end = lay_out(*sequence->element, slot.end);
  slots_[column] = slot;
  return slot.end;
}

const std::vector<std::string>& Row::read(sample::ByteView cdr) {
  for (std::string& cell : cells_) cell.clear();
  open_.clear();
  hidden_ = 0;
  column_ = 0;
  sample::visit_sample(type_, cdr, *this);
  return cells_;
}

/// True where the value that begins now has no columns.
bool Row::passes_over() {
  if (hidden_ > 0) return true;
  return !open_.empty() && open_.back().is_sequence &&
         open_.back().element >= open_.back().slot.shown;
}

void Row::begin_struct(const sample::StructType&) {
  if (passes_over()) {
    ++hidden_;
  } else {
    open_.emplace_back();
  }
}

void Row::member(const std::string&) {}

void Row::begin_list(std::size_t size, bool is_sequence) {
  if (passes_over()) {
    ++hidden_;
    return;
  }
  Open list;
  if (is_sequence) {
    list.is_sequence = true;
    list.slot = slots_.at(column_);
    put(std::uint64_t{size});
  }
  open_.push_back(list);
}

void Row::scalar(const sample::Scalar& value) {
  if (hidden_ > 0) return;
  if (!passes_over()) put(value);
  if (!open_.empty()) ++open_.back().element;
}

void Row::leave() {
  if (hidden_ > 0) {
    --hidden_;
  } else {
    const Open done = open_.back();
    open_.pop_back();
    if (done.is_sequence) column_ = done.slot.end;
  }
  if (hidden_ == 0 && !open_.empty()) ++open_.back().element;
}

void Row::put(const sample::Scalar& value) {
  if (wanted_[column_] != 0) append_plain(cells_[column_], value);
  ++column_;
}

}  // namespace scarab::log
