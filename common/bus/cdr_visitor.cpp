#include "common/bus/cdr_visitor.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "common/bus/error.hpp"

namespace scarab::bus {

namespace {

/// Reads primitives from CDR bytes with their alignment and byte order.
class Cursor {
 public:
  explicit Cursor(ByteView cdr) {
    if (cdr.size < kHeaderSize) throw Error("no encapsulation header");
    const auto representation = std::to_integer<unsigned>(cdr.data[1]);
    if (cdr.data[0] != std::byte{0} || representation > 1) {
      throw Error("representation is not plain CDR");
    }
    swap_ = representation == 0;  // this project runs on little-endian machines
    payload_ = {cdr.data + kHeaderSize, cdr.size - kHeaderSize};
  }

  template <class T>
  T read() {
    align(sizeof(T));
    std::array<std::byte, sizeof(T)> bytes;
    const ByteView raw = take(sizeof(T));
    std::copy_n(raw.data, sizeof(T), bytes.begin());
    if (swap_) std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  std::string_view read_string(std::uint32_t bound) {
    const auto size = read<std::uint32_t>();  // with its terminating zero
    if (size == 0) throw Error("a string without end");
    if (bound != 0 && size > bound + 1) throw Error("a string beyond its bound");
    const ByteView raw = take(size);
    if (raw.data[size - 1] != std::byte{0}) throw Error("a string without end");
    return {reinterpret_cast<const char*>(raw.data), size - 1};
  }

  std::size_t left() const { return payload_.size - at_; }

 private:
  static constexpr std::size_t kHeaderSize = 4;

  void align(std::size_t size) { at_ = (at_ + size - 1) / size * size; }

  ByteView take(std::size_t size) {
    if (at_ > payload_.size || size > left()) throw Error("the bytes end early");
    at_ += size;
    return {payload_.data + at_ - size, size};
  }

  ByteView payload_;
  std::size_t at_ = 0;
  bool swap_ = false;
};

class Walk {
 public:
  Walk(ByteView cdr, SampleVisitor& visitor) : cursor_(cdr), visitor_(visitor) {}

  void value(const Type& type) { std::visit(*this, type.kind); }

  void operator()(Primitive primitive) { visitor_.scalar(read(primitive)); }
  void operator()(const StringType& type) { visitor_.scalar(cursor_.read_string(type.bound)); }
  void operator()(const EnumType& type) {
    const auto number = cursor_.read<std::int32_t>();
    visitor_.scalar(EnumValue{number, type.name_of(number)});
  }
  void operator()(const AliasType& type) { value(*type.target); }
  void operator()(const StructType& type) {
    visitor_.begin_struct(type);
    for (const Member& member : type.members) {
      visitor_.member(member.name);
      value(*member.type);
    }
    visitor_.end_struct();
  }
  void operator()(const ArrayType& type) { dimension(type, 0); }
  void operator()(const SequenceType& type) {
    const auto size = cursor_.read<std::uint32_t>();
    if (type.bound != 0 && size > type.bound) throw Error("a sequence beyond its bound");
    // Every element takes at least a byte: refuses absurd lengths before anybody makes room for
    // them.
    if (size > cursor_.left()) throw Error("the bytes end early");
    visitor_.begin_list(size, true);
    for (std::uint32_t i = 0; i < size; ++i) value(*type.element);
    visitor_.end_list();
  }

 private:
  void dimension(const ArrayType& type, std::size_t depth) {
    if (depth == type.dimensions.size()) return value(*type.element);
    visitor_.begin_list(type.dimensions[depth], false);
    for (std::uint32_t i = 0; i < type.dimensions[depth]; ++i) dimension(type, depth + 1);
    visitor_.end_list();
  }

  Scalar read(Primitive primitive) {
    switch (primitive) {
      case Primitive::kBoolean:
        return cursor_.read<std::uint8_t>() != 0;
      case Primitive::kOctet:
        return std::uint64_t{cursor_.read<std::uint8_t>()};
      case Primitive::kChar:
        return cursor_.read<char>();
      case Primitive::kInt8:
        return std::int64_t{cursor_.read<std::int8_t>()};
      case Primitive::kInt16:
        return std::int64_t{cursor_.read<std::int16_t>()};
      case Primitive::kInt32:
        return std::int64_t{cursor_.read<std::int32_t>()};
      case Primitive::kInt64:
        return cursor_.read<std::int64_t>();
      case Primitive::kUint16:
        return std::uint64_t{cursor_.read<std::uint16_t>()};
      case Primitive::kUint32:
        return std::uint64_t{cursor_.read<std::uint32_t>()};
      case Primitive::kUint64:
        return cursor_.read<std::uint64_t>();
      case Primitive::kFloat:
        return cursor_.read<float>();
      case Primitive::kDouble:
        return cursor_.read<double>();
    }
    throw Error("unknown primitive");
  }

  Cursor cursor_;
  SampleVisitor& visitor_;
};

}  // namespace

void visit_sample(const TypeModel& model, ByteView cdr, SampleVisitor& visitor) {
  try {
    Walk(cdr, visitor).value(*model.type());
  } catch (const Error& error) {
    throw Error(model.name() + ": " + error.what());
  }
}

}  // namespace scarab::bus
