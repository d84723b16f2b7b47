#include "common/bus/c_layout.hpp"

#include <algorithm>
#include <cstdint>

namespace scarab::bus {

namespace {

/// What idlc declares for every sequence.
struct Sequence {
  std::uint32_t maximum;
  std::uint32_t length;
  void* buffer;
  bool release;
};

enum class AnyEnum { kZero };

template <class T>
constexpr CLayout layout_of() {
  return {sizeof(T), alignof(T)};
}

std::size_t align(std::size_t offset, std::size_t alignment) {
  return (offset + alignment - 1) / alignment * alignment;
}

struct LayoutOf {
  CLayout operator()(sample::Primitive primitive) const {
    switch (primitive) {
      case sample::Primitive::kBoolean:
      case sample::Primitive::kOctet:
      case sample::Primitive::kChar:
      case sample::Primitive::kInt8:
        return layout_of<std::uint8_t>();
      case sample::Primitive::kInt16:
      case sample::Primitive::kUint16:
        return layout_of<std::uint16_t>();
      case sample::Primitive::kInt32:
      case sample::Primitive::kUint32:
        return layout_of<std::uint32_t>();
      case sample::Primitive::kInt64:
      case sample::Primitive::kUint64:
        return layout_of<std::uint64_t>();
      case sample::Primitive::kFloat:
        return layout_of<float>();
      case sample::Primitive::kDouble:
        return layout_of<double>();
    }
    return {};
  }
  CLayout operator()(const sample::StringType& type) const {
    return type.bound == 0 ? layout_of<char*>() : CLayout{type.bound + std::size_t{1}, 1};
  }
  CLayout operator()(const sample::EnumType&) const { return layout_of<AnyEnum>(); }
  CLayout operator()(const sample::SequenceType&) const { return layout_of<Sequence>(); }
  CLayout operator()(const sample::AliasType& type) const { return c_layout(*type.target); }
  CLayout operator()(const sample::ArrayType& type) const {
    const CLayout element = c_layout(*type.element);
    return {element.size * type.count(), element.alignment};
  }
  CLayout operator()(const sample::StructType& type) const {
    CLayout all;
    for (const sample::Member& member : type.members) {
      const CLayout one = c_layout(*member.type);
      all.size = align(all.size, one.alignment) + one.size;
      all.alignment = std::max(all.alignment, one.alignment);
    }
    all.size = align(all.size, all.alignment);
    return all;
  }
};

}  // namespace

CLayout c_layout(const sample::Type& type) { return std::visit(LayoutOf{}, type.kind); }

std::vector<std::size_t> member_offsets(const sample::StructType& type) {
  std::vector<std::size_t> offsets;
  std::size_t at = 0;
  for (const sample::Member& member : type.members) {
    const CLayout one = c_layout(*member.type);
    offsets.push_back(align(at, one.alignment));
    at = offsets.back() + one.size;
  }
  return offsets;
}

}  // namespace scarab::bus
