#pragma once

#include <mutex>
#include <set>

#include "tests/interop/fastdds/node.hpp"

namespace scarab::fastdds {

/// The remote endpoints that an endpoint has matched, as the vendor's threads report them.
class Matches {
 public:
  /// change: +1 matched, -1 gone.
  void note(const Guid& endpoint, int change) {
    const std::lock_guard lock(mutex_);
    if (change > 0) endpoints_.insert(endpoint);
    if (change < 0) endpoints_.erase(endpoint);
  }
  [[nodiscard]] std::set<Guid> all() const {
    const std::lock_guard lock(mutex_);
    return endpoints_;
  }

 private:
  mutable std::mutex mutex_;
  std::set<Guid> endpoints_;
};

}  // namespace scarab::fastdds
