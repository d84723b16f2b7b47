#include "common/sample/cdr_visitor.hpp"

#include "common/sample/cdr_cursor.hpp"
#include "common/sample/cdr_rules.hpp"
#include "common/sample/error.hpp"

namespace scarab::sample {

namespace {

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
    const CdrCursor::Delimited part(cursor_, cursor_.is_xcdr2() && is_delimited(type));
    visitor_.begin_struct(type);
    for (const Member& member : type.members) {
      visitor_.member(member.name);
      value(*member.type);
    }
    visitor_.end_struct();
  }
  void operator()(const ArrayType& type) {
    const CdrCursor::Delimited part(cursor_, cursor_.is_xcdr2() && is_delimited(type));
    dimension(type, 0);
  }
  void operator()(const SequenceType& type) {
    const CdrCursor::Delimited part(cursor_, cursor_.is_xcdr2() && is_delimited(type));
    const auto size = cursor_.checked_size(cursor_.read<std::uint32_t>());
    if (type.bound != 0 && size > type.bound) throw Error("a sequence beyond its bound");
    visitor_.begin_list(size, true);
    for (std::uint32_t i = 0; i < size; ++i) value(*type.element);
    visitor_.end_list();
  }

 private:
  void dimension(const ArrayType& type, std::size_t depth) {
    if (depth == type.dimensions.size()) {
      // An array of arrays has one length before it, see is_delimited().
      const Type& element = resolve(*type.element);
      if (const auto* inner = std::get_if<ArrayType>(&element.kind)) return dimension(*inner, 0);
      return value(element);
    }
    visitor_.begin_list(cursor_.checked_size(type.dimensions[depth]), false);
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

  CdrCursor cursor_;
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

}  // namespace scarab::sample
