#include "tests/integration/types/sample_filler.hpp"

#include <algorithm>
#include <cstring>

#include "common/bus/c_layout.hpp"
#include "common/bus/topic_type.hpp"

namespace scarab::test {

namespace {

using namespace sample;  // NOLINT: the types of the model, all of them

/// Fills one value after the other and writes what it has filled in.
class Filler {
 public:
  /// Fills the memory of a value of the type; returns its JSON.
  std::string fill(const Type& type, std::byte* at) {
    at_ = at;
    return std::visit(*this, type.kind);
  }

  std::string operator()(Primitive primitive) {
    ++count_;
    switch (primitive) {
      case Primitive::kBoolean:
        store(std::uint8_t{1});
        return "true";
      case Primitive::kOctet:
        return store_number(static_cast<std::uint8_t>(count_ % 255 + 1));
      case Primitive::kChar: {
        const char letter = static_cast<char>('a' + count_ % 26);
        store(letter);
        return "\"" + std::string(1, letter) + "\"";
      }
      case Primitive::kInt8:
        return store_number(static_cast<std::int8_t>(-(count_ % 127) - 1));
      case Primitive::kInt16:
        return store_number(static_cast<std::int16_t>(-count_));
      case Primitive::kInt32:
        return store_number(static_cast<std::int32_t>(-count_ - 100'000));
      case Primitive::kInt64:
        return store_number(static_cast<std::int64_t>(-count_ - 10'000'000'000));
      case Primitive::kUint16:
        return store_number(static_cast<std::uint16_t>(60'000 + count_));
      case Primitive::kUint32:
        return store_number(static_cast<std::uint32_t>(4'000'000'000 + count_));
      case Primitive::kUint64:
        return store_number(18'000'000'000'000'000'000U + static_cast<std::uint64_t>(count_));
      case Primitive::kFloat:
        store(static_cast<float>(count_) + 0.5F);
        return std::to_string(count_) + ".5";
      case Primitive::kDouble:
        store(-static_cast<double>(count_) - 0.25);
        return "-" + std::to_string(count_) + ".25";
    }
    return {};
  }

  std::string operator()(const StringType& type) {
    std::string text = std::to_string(++count_) + " is more than the 16 bytes of a key, \xC3\xA4";
    if (type.bound == 0) {
      store(dds_string_dup(text.c_str()));
    } else {
      text = text.substr(0, std::min<std::size_t>(text.size(), type.bound));
      std::memcpy(at_, text.c_str(), text.size() + 1);
    }
    return "\"" + text + "\"";
  }

  std::string operator()(const EnumType& type) {
    const auto others = static_cast<long>(type.literals.size()) - 1;  // than the first, the default
    const Literal& literal =
        type.literals[static_cast<std::size_t>(others > 0 ? count_ % others + 1 : 0)];
    ++count_;
    store(literal.value);
    return "\"" + literal.name + "\"";
  }

  std::string operator()(const AliasType& type) { return fill(*type.target, at_); }

  std::string operator()(const StructType& type) {
    std::byte* const first = at_;
    const std::vector<std::size_t> offsets = bus::member_offsets(type);
    std::string out;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const Member& member = type.members[i];
      out += (i == 0 ? "\"" : ", \"") + member.name + "\": ";
      out += fill(*member.type, first + offsets[i]);
    }
    return "{" + out + "}";
  }

  std::string operator()(const ArrayType& type) {
    std::byte* next = at_;
    return dimension(type, 0, next);
  }

  std::string operator()(const SequenceType& type) {
    const std::uint32_t size = type.bound == 1 ? 1 : 2;
    const std::size_t stride = bus::c_layout(*type.element).size;
    auto* buffer = static_cast<std::uint8_t*>(dds_alloc(size * stride));
    store(dds_sequence_t{size, size, buffer, true});
    std::byte* next = reinterpret_cast<std::byte*>(buffer);
    return list(size, [&] {
      std::byte* const element = next;
      next += stride;
      return fill(*type.element, element);
    });
  }

 private:
  std::string dimension(const ArrayType& type, std::size_t depth, std::byte*& next) {
    if (depth == type.dimensions.size()) {
      std::byte* const element = next;
      next += bus::c_layout(*type.element).size;
      return fill(*type.element, element);
    }
    return list(type.dimensions[depth], [&] { return dimension(type, depth + 1, next); });
  }

  template <class F>
  static std::string list(std::uint32_t size, F&& element) {
    std::string out;
    for (std::uint32_t i = 0; i < size; ++i) out += (i == 0 ? "" : ", ") + element();
    return "[" + out + "]";
  }

  template <class T>
  void store(T value) {
    std::memcpy(at_, &value, sizeof(T));
  }
  template <class T>
  std::string store_number(T value) {
    store(value);
    return std::to_string(value);
  }

  std::byte* at_ = nullptr;
  long count_ = 0;
};

}  // namespace

FilledSample::FilledSample(const dds_topic_descriptor_t& type)
    : type_(type), memory_(dds_alloc(type.m_size)) {
  const TypeModel model = bus::model_of(type);
  json_ = Filler().fill(*model.type(), static_cast<std::byte*>(memory_));
}

FilledSample::~FilledSample() { dds_sample_free(memory_, &type_, DDS_FREE_ALL); }

}  // namespace scarab::test
