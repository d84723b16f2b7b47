#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "common/sample/bytes.hpp"

namespace scarab::sample {

/// Writes values one after the other as CDR, little-endian, as this project's machines are.
class CdrOutput {
 public:
  /// How the whole is written: the second byte of its encapsulation header.
  enum class Encoding : std::uint8_t { kXcdr1 = 1, kXcdr2 = 7, kDelimitedXcdr2 = 9 };

  explicit CdrOutput(Encoding encoding) : encoding_(encoding) {}

  bool is_xcdr2() const { return encoding_ != Encoding::kXcdr1; }

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
    bytes_[1] = static_cast<std::byte>(encoding_);
    bytes_[3] = static_cast<std::byte>(padding);
    return std::move(bytes_);
  }

  /// A part with its length before it: what is written during the object's life.
  class Delimited {
   public:
    /// `present` false: no length is written.
    Delimited(CdrOutput& out, bool present) : out_(out), present_(present) {
      if (!present) return;
      out.write(std::uint32_t{0});
      first_ = out.bytes_.size();
    }
    Delimited(const Delimited&) = delete;
    Delimited& operator=(const Delimited&) = delete;
    ~Delimited() {
      if (!present_) return;
      const auto size = static_cast<std::uint32_t>(out_.bytes_.size() - first_);
      std::memcpy(out_.bytes_.data() + first_ - sizeof(size), &size, sizeof(size));
    }

   private:
    CdrOutput& out_;
    bool present_;
    std::size_t first_ = 0;
  };

 private:
  static constexpr std::size_t kHeaderSize = 4;

  void align(std::size_t size) {
    const std::size_t alignment = std::min(size, std::size_t{is_xcdr2() ? 4U : 8U});
    const std::size_t payload = bytes_.size() - kHeaderSize;
    bytes_.resize(kHeaderSize + (payload + alignment - 1) / alignment * alignment, std::byte{0});
  }

  Encoding encoding_;
  Bytes bytes_ = Bytes(kHeaderSize, std::byte{0});
};

}  // namespace scarab::sample
