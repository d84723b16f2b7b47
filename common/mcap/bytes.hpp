#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace scarab::mcap {

using Bytes = std::vector<std::uint8_t>;

/// Bytes that somebody else owns; valid as long as the owner leaves them alone.
class ByteView {
 public:
  ByteView() = default;
  ByteView(const void* data, std::size_t size)
      : data_(static_cast<const std::uint8_t*>(data)), size_(size) {}
  ByteView(const Bytes& bytes) : ByteView(bytes.data(), bytes.size()) {}
  ByteView(std::string_view text) : ByteView(text.data(), text.size()) {}

  const std::uint8_t* data() const { return data_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const std::uint8_t* begin() const { return data_; }
  const std::uint8_t* end() const { return data_ + size_; }
  std::uint8_t operator[](std::size_t index) const { return data_[index]; }

  /// The `size` bytes from `offset` on; the caller has checked that they are there.
  ByteView slice(std::size_t offset, std::size_t size) const { return {data_ + offset, size}; }

 private:
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

/// A copy that owns its bytes.
inline Bytes copy_of(ByteView view) { return Bytes(view.begin(), view.end()); }

}  // namespace scarab::mcap
