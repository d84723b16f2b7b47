#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "common/bus/raw_cdr.hpp"

namespace scarab::bus {

/// Writes values one after the other as XCDR1, little-endian, as this project's machines are.
class CdrOutput {
 public:
  template <class T>
  void write(T value) {
    align(sizeof(T));
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }

  void write_text(std::string_view text) {
    write(static_cast<std::uint32_t>(text.size() + 1));
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    bytes_.insert(bytes_.end(), first, first + text.size());
    bytes_.push_back(std::byte{0});
  }

  /// What has been written, padded to a multiple of 4, which the header tells.
  Bytes finish() {
    const std::size_t padding = (4 - bytes_.size() % 4) % 4;
    bytes_.resize(bytes_.size() + padding, std::byte{0});
    bytes_[1] = std::byte{1};
    bytes_[3] = static_cast<std::byte>(padding);
    return std::move(bytes_);
  }

 private:
  static constexpr std::size_t kHeaderSize = 4;

  void align(std::size_t size) {
    const std::size_t payload = bytes_.size() - kHeaderSize;
    bytes_.resize(kHeaderSize + (payload + size - 1) / size * size, std::byte{0});
  }

  Bytes bytes_ = Bytes(kHeaderSize, std::byte{0});
};

}  // namespace scarab::bus
