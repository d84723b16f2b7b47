#include "common/sample/cdr_cursor.hpp"

#include "common/sample/encapsulation.hpp"
#include "common/sample/error.hpp"

namespace scarab::sample {

CdrCursor::CdrCursor(ByteView cdr) {
  const Encapsulation encapsulation = encapsulation_of(cdr);
  if (encapsulation.is_list) throw Error("representation is a parameter list");
  payload_ = {cdr.data + Encapsulation::kSize, cdr.size - Encapsulation::kSize};
  end_ = payload_.size;
  swapped_ = encapsulation.swapped;
  largest_alignment_ = encapsulation.xcdr2 ? 4 : 8;
}

std::string_view CdrCursor::read_string(std::uint32_t bound) {
  const auto size = read<std::uint32_t>();  // with its terminating zero
  if (size == 0) throw Error("a string without end");
  if (bound != 0 && size - 1 > bound) throw Error("a string beyond its bound");
  const ByteView raw = take(size);
  if (raw.data[size - 1] != std::byte{0}) throw Error("a string without end");
  return {reinterpret_cast<const char*>(raw.data), size - 1};
}

std::uint32_t CdrCursor::checked_size(std::uint32_t elements) const {
  if (elements > left()) throw Error("the bytes end early");
  return elements;
}

void CdrCursor::align(std::size_t size) {
  const std::size_t alignment = std::min(size, largest_alignment_);
  const std::size_t padding = (alignment - at_ % alignment) % alignment;
  take(padding);
}

ByteView CdrCursor::take(std::size_t size) {
  if (size > left()) throw Error("the bytes end early");
  at_ += size;
  return {payload_.data + at_ - size, size};
}

CdrCursor::Delimited::Delimited(CdrCursor& cursor, bool present)
    : cursor_(cursor), outer_end_(cursor.end_), present_(present) {
  if (!present) return;
  const auto size = cursor.read<std::uint32_t>();
  if (size > cursor.left()) throw Error("the bytes end early");
  cursor.end_ = cursor.at_ + size;
}

CdrCursor::Delimited::~Delimited() {
  if (!present_) return;
  cursor_.at_ = cursor_.end_;
  cursor_.end_ = outer_end_;
}

}  // namespace scarab::sample
