#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scarab::bridge::dynamixel {

using Bytes = std::vector<std::uint8_t>;

/// Bytes that somebody else owns; valid as long as the owner leaves them alone.
class ByteView {
 public:
  ByteView() = default;
  ByteView(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  ByteView(const Bytes& bytes) : ByteView(bytes.data(), bytes.size()) {}

  [[nodiscard]] const std::uint8_t* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const std::uint8_t* begin() const { return data_; }
  [[nodiscard]] const std::uint8_t* end() const { return data_ + size_; }
  std::uint8_t operator[](std::size_t index) const { return data_[index]; }

  /// The `size` bytes from `offset` on; the caller has checked that they are there.
  [[nodiscard]] ByteView slice(std::size_t offset, std::size_t size) const {
    return {data_ + offset, size};
  }
  /// All from `offset` on.
  [[nodiscard]] ByteView from(std::size_t offset) const { return {data_ + offset, size_ - offset}; }
  [[nodiscard]] Bytes copy() const { return Bytes(begin(), end()); }

 private:
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

/// Appends the `size` low bytes of `value`, the lowest first: the order of everything in the
/// protocol.
inline void append_little(Bytes& bytes, std::uint32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

/// The unsigned number in all of `bytes`, which are at most 4.
inline std::uint32_t read_little(ByteView bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    value |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
  }
  return value;
}

}  // namespace scarab::bridge::dynamixel
