#include "common/bus/sample_check.hpp"

#include <algorithm>
#include <cstring>

#include "common/bus/c_layout.hpp"
#include "common/bus/error.hpp"
#include "common/bus/topic_type.hpp"

namespace scarab::bus {

namespace {

template <class T>
T read(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

void cover(const sample::Type& type, std::size_t offset, std::vector<bool>& covered) {
  const sample::Type& plain = sample::resolve(type);
  if (const auto* structure = std::get_if<sample::StructType>(&plain.kind)) {
    const std::vector<std::size_t> offsets = member_offsets(*structure);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      cover(*structure->members[i].type, offset + offsets[i], covered);
    }
  } else if (const auto* array = std::get_if<sample::ArrayType>(&plain.kind)) {
    const std::size_t stride = c_layout(*array->element).size;
    for (std::size_t i = 0; i < array->count(); ++i) {
      cover(*array->element, offset + i * stride, covered);
    }
  } else {
    const auto first = covered.begin() + static_cast<std::ptrdiff_t>(offset);
    std::fill_n(first, c_layout(plain).size, true);
  }
}

}  // namespace

SampleCheck::SampleCheck(const dds_topic_descriptor_t& descriptor) {
  const sample::TypeModel model = model_of(descriptor);
  const CLayout layout = c_layout(*model.type());
  if (layout.size != descriptor.m_size || layout.alignment != descriptor.m_align) {
    throw Error("type " + model.name() + ": its C struct is not that of its type information");
  }
  fields_ = fields_of(model.type(), 0, "");
  size_ = layout.size;
  std::vector<bool> covered(size_);  // for each byte of the struct: it belongs to a member
  cover(*model.type(), 0, covered);
  for (std::size_t i = 0; i < size_; ++i) {
    if (covered[i]) continue;
    if (padding_.empty() || padding_.back().end != i) padding_.push_back({i, i});
    padding_.back().end = i + 1;
  }
}

std::vector<SampleCheck::Field> SampleCheck::fields_of(const sample::TypeRef& type,
                                                       std::size_t offset,
                                                       const std::string& name) {
  const sample::Type& plain = sample::resolve(*type);
  if (const auto* structure = std::get_if<sample::StructType>(&plain.kind)) {
    return fields_of_struct(*structure, offset, name);
  }
  if (std::holds_alternative<sample::EnumType>(plain.kind)) {
    // The enum lives as long as the tree that refers to it.
    return {{Field::Kind::kEnum, name, offset, 0, 0, sample::TypeRef(type, &plain), {}}};
  }
  if (const auto* primitive = std::get_if<sample::Primitive>(&plain.kind)) {
    if (*primitive != sample::Primitive::kBoolean) return {};
    return {{Field::Kind::kBoolean, name, offset, 0, 0, nullptr, {}}};
  }
  if (const auto* string = std::get_if<sample::StringType>(&plain.kind)) {
    if (string->bound == 0) return {};
    return {{Field::Kind::kText, name, offset, string->bound, 0, nullptr, {}}};
  }
  return fields_of_list(plain, offset, name);
}

std::vector<SampleCheck::Field> SampleCheck::fields_of_struct(const sample::StructType& type,
                                                              std::size_t offset,
                                                              const std::string& name) {
  std::vector<Field> out;
  const std::vector<std::size_t> offsets = member_offsets(type);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const sample::Member& member = type.members[i];
    const std::string path = name.empty() ? member.name : name + "." + member.name;
    for (Field& field : fields_of(member.type, offset + offsets[i], path)) {
      out.push_back(std::move(field));
    }
  }
  return out;
}

std::vector<SampleCheck::Field> SampleCheck::fields_of_list(const sample::Type& type,
                                                            std::size_t offset,
                                                            const std::string& name) {
  if (const auto* array = std::get_if<sample::ArrayType>(&type.kind)) {
    std::vector<Field> element = fields_of(array->element, 0, "");
    if (element.empty()) return {};
    return {{Field::Kind::kArray, name, offset, array->count(), c_layout(*array->element).size,
             nullptr, std::move(element)}};
  }
  const auto& sequence = std::get<sample::SequenceType>(type.kind);
  return {{Field::Kind::kSequence, name, offset, sequence.bound, c_layout(*sequence.element).size,
           nullptr, fields_of(sequence.element, 0, "")}};
}

void SampleCheck::check(const void* sample) const {
  check_all(fields_, static_cast<const std::byte*>(sample));
}

void SampleCheck::check_all(const std::vector<Field>& fields, const std::byte* base) {
  for (const Field& field : fields) check_one(field, base);
}

void SampleCheck::check_one(const Field& field, const std::byte* base) {
  const std::byte* at = base + field.offset;
  switch (field.kind) {
    case Field::Kind::kBoolean:
      if (read<std::uint8_t>(at) > 1) throw Error(field.name + ": neither true nor false");
      break;
    case Field::Kind::kEnum: {
      const auto& type = std::get<sample::EnumType>(field.type->kind);
      const auto value = read<std::int32_t>(at);
      if (type.name_of(value) != nullptr) break;
      throw Error(field.name + ": " + std::to_string(value) + " is no " + type.name);
    }
    case Field::Kind::kText:
      if (std::memchr(at, 0, field.bound + 1) == nullptr) {
        throw Error(field.name + ": text without end");
      }
      break;
    case Field::Kind::kArray:
      check_list(field, at, field.bound);
      break;
    case Field::Kind::kSequence: {
      const auto sequence = read<dds_sequence_t>(at);
      if (field.bound != 0 && sequence._length > field.bound) {
        throw Error(field.name + ": " + std::to_string(sequence._length) + " elements, at most " +
                    std::to_string(field.bound));
      }
      check_list(field, reinterpret_cast<const std::byte*>(sequence._buffer), sequence._length);
    }
  }
}

void SampleCheck::check_list(const Field& field, const std::byte* first, std::size_t count) {
  if (field.element.empty()) return;
  for (std::size_t i = 0; i < count; ++i) {
    try {
      check_all(field.element, first + i * field.stride);
    } catch (const Error& error) {
      const std::string what = error.what();
      const std::string separator = what.front() == ':' ? "" : ".";
      throw Error(field.name + "[" + std::to_string(i) + "]" + separator + what);
    }
  }
}

const void* SampleCheck::without_padding(const void* sample, std::vector<std::byte>& buffer) const {
  if (padding_.empty()) return sample;
  const auto* bytes = static_cast<const std::byte*>(sample);
  buffer.assign(bytes, bytes + size_);
  for (const Range& range : padding_) {
    std::fill(buffer.data() + range.begin, buffer.data() + range.end, std::byte{0});
  }
  return buffer.data();
}

}  // namespace scarab::bus
