#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "common/config/document.hpp"
#include "tools/search/description.hpp"
#include "tools/sim/composition.hpp"

namespace scarab::search {

inline constexpr std::array<std::string_view, 4> kKinds = {"robot", "plant", "premotor",
                                                           "supervisor"};

/// The four configuration files of a robot as one tree, whose paths begin with the kind of the
/// file: `premotor.motor.front.t_offset_rad`.
class ConfigurationTree {
 public:
  /// Reads the base files, their names relative to `folder`. Throws config::Error.
  ConfigurationTree(const BaseNames& names, const std::filesystem::path& folder);

  [[nodiscard]] bool has_number(std::string_view path) const;
  /// Both throw std::invalid_argument if there is no number at `path`.
  [[nodiscard]] double number(std::string_view path) const;
  void set_number(std::string_view path, double value);

  /// The file a kind was read from, and those it extends.
  [[nodiscard]] const config::Document& document(std::string_view kind) const;
  /// YAML of one kind as it stands.
  [[nodiscard]] std::string text(std::string_view kind) const;
  /// Reads all four strictly. Throws config::Error.
  [[nodiscard]] sim::Configuration build() const;

 private:
  [[nodiscard]] std::string name(std::string_view kind) const;

  std::array<config::Document, kKinds.size()> documents_;
};

/// The kind a path begins with, and the rest; the kind is empty if it is none.
struct SplitPath {
  std::string_view kind, rest;
};
[[nodiscard]] SplitPath split_path(std::string_view path);

}  // namespace scarab::search
