#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "common/config/cursor.hpp"

namespace scarab::config {

/// Given to validate(const X&, const Check&), which sees a whole struct once each of its keys has
/// been read: the place for conditions between keys.
class Check {
 public:
  explicit Check(Cursor at) : at_(std::move(at)) {}

  /// Throws Error at `key` (a dotted path below the struct) with the reason, unless `ok`.
  void require(bool ok, std::string_view key, std::string_view reason) const {
    if (!ok) at_.fail_at(key, reason);
  }

 private:
  Cursor at_;
};

}  // namespace scarab::config
