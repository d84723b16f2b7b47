#include "services/robot_bridge/drivers/dynamixel/protocol/control_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::array<std::pair<std::uint8_t, std::string_view>, 5> kHardwareErrors = {
    {{kInputVoltageError, "input voltage"},
     {kOverheatingError, "overheating"},
     {kEncoderError, "motor encoder"},
     {kElectricalShockError, "electrical shock"},
     {kOverloadError, "overload"}}};

/// The counts an integer type can hold.
struct Counts {
  std::int64_t min;
  std::int64_t max;
};

constexpr Counts counts_of(Type type) {
  const std::int64_t all = std::int64_t{1} << (8 * size_of(type));
  const bool is_signed = type == Type::kI8 || type == Type::kI16 || type == Type::kI32;
  return is_signed ? Counts{-all / 2, all / 2 - 1} : Counts{0, all - 1};
}

float float_of(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

std::int64_t count_in(const Item& item, ByteView data) {
  const std::int64_t count = read_little(data);
  const Counts counts = counts_of(item.type);
  return count > counts.max ? count - counts.max - 1 + counts.min : count;
}

Bytes bytes_of(const Item& item, std::int64_t count) {
  Bytes bytes;
  append_little(bytes, static_cast<std::uint32_t>(count), item.size());
  return bytes;
}

double value_in(const Item& item, ByteView data) {
  if (item.type == Type::kF32) return double{float_of(read_little(data))} * item.unit;
  return static_cast<double>(count_in(item, data)) * item.unit;
}

Bytes bytes_of_value(const Item& item, double value) {
  const double count = value / item.unit;
  if (item.type == Type::kF32) return bytes_of(item, bits_of(static_cast<float>(count)));
  const Counts counts = counts_of(item.type);
  return bytes_of(item, std::llround(std::clamp(count, static_cast<double>(counts.min),
                                                static_cast<double>(counts.max))));
}

Region hull(Region a, Region b) {
  const std::uint16_t begin = std::min(a.address, b.address);
  const int end = std::max(a.address + a.size, b.address + b.size);
  return {begin, static_cast<std::uint16_t>(end - begin)};
}

std::string hardware_error_text(std::uint8_t bits) {
  std::string text;
  const auto add = [&](std::string_view name) {
    if (!text.empty()) text += ", ";
    text += name;
  };
  for (const auto& [bit, name] : kHardwareErrors) {
    if ((bits & bit) != 0) add(name);
    bits = static_cast<std::uint8_t>(bits & ~bit);
  }
  if (bits != 0) add("unknown bits " + std::to_string(static_cast<int>(bits)));
  return text;
}

}  // namespace scarab::bridge::dynamixel
