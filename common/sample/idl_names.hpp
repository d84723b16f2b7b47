#pragma once

#include <map>
#include <string>
#include <utility>

namespace scarab::sample {

/// Where a declaration of IDL stands: the modules around it, as `a::b::`; empty outside of all.
using IdlScope = std::string;

/// The declarations of one kind in an IDL text, found by IDL's scoping rules (4.2, 7.5).
template <class T>
class IdlNames {
 public:
  /// False if the full name is taken.
  bool declare(const std::string& full_name, T value) {
    return declared_.emplace(full_name, std::move(value)).second;
  }

  /// What a name, written in `scope`, means: the declaration in the innermost module that has it.
  /// Null if there is none.
  const T* find(IdlScope scope, const std::string& name) const {
    if (name.compare(0, 2, "::") == 0) return find_full(name.substr(2));
    while (true) {
      const T* found = find_full(scope + name);
      if (found != nullptr || scope.empty()) return found;
      scope.resize(scope.size() - 2);
      const std::size_t colons = scope.rfind("::");
      scope.resize(colons == IdlScope::npos ? 0 : colons + 2);
    }
  }

  const T* find_full(const std::string& full_name) const {
    const auto found = declared_.find(full_name);
    return found == declared_.end() ? nullptr : &found->second;
  }

 private:
  std::map<std::string, T> declared_;
};

}  // namespace scarab::sample
