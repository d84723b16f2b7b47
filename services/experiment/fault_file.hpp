#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace scarab::experiment {

/// A file that appears when no trial can go on, with the reason: whoever keeps the processes of the
/// stack sees one of them die before its peers miss it.
class FaultFile {
 public:
  /// Empty: there will never be a fault.
  explicit FaultFile(std::filesystem::path path) : path_(std::move(path)) {}

  /// The reason, in words; nothing while all is well.
  [[nodiscard]] std::optional<std::string> reason() const;

 private:
  std::filesystem::path path_;
};

}  // namespace scarab::experiment
