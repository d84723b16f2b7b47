#pragma once

#include <string>
#include <vector>

#include "common/config/error.hpp"

namespace scarab::config {

/// A key of a map and where it stands.
struct Key {
  std::string text;
  Position position;
};

/// A YAML node without interpretation: scalars are text, maps keep their order.
struct Value {
  enum class Kind { kNothing, kScalar, kList, kMap };

  Kind kind = Kind::kNothing;
  Position position;
  std::string text;       ///< of a scalar
  bool plain = true;      ///< scalar without quotes; only such a one is a number or a truth value
  std::vector<Key> keys;  ///< of a map; keys[i] names items[i]
  std::vector<Value> items;  ///< of a map or a list
};

}  // namespace scarab::config
