#pragma once

#include <filesystem>
#include <string>

#include "tests/support/programs.hpp"

namespace scarab::test {

/// The programs of this folder, on npm packages of others.
class NpmReaders {
 public:
  /// Installs the packages, pinned by package-lock.json, into the build directory, unless they are
  /// there. Throws std::runtime_error naming what is missing.
  NpmReaders();

  /// Runs one, such as compare_cat.mjs.
  [[nodiscard]] Finished run(const std::string& name, const Arguments& arguments) const;

 private:
  std::filesystem::path installed_;
};

}  // namespace scarab::test
