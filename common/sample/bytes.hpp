#pragma once

#include <cstddef>
#include <vector>

namespace scarab::sample {

using Bytes = std::vector<std::byte>;

/// Borrowed bytes.
struct ByteView {
  ByteView() = default;
  ByteView(const std::byte* first, std::size_t count) : data(first), size(count) {}
  ByteView(const Bytes& bytes) : data(bytes.data()), size(bytes.size()) {}  // NOLINT: a view

  const std::byte* data = nullptr;
  std::size_t size = 0;
};

}  // namespace scarab::sample
