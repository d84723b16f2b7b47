#pragma once

#include <filesystem>
#include <vector>

#include "tools/search/configuration_tree.hpp"
#include "tools/search/description.hpp"
#include "tools/search/parameter_space.hpp"

namespace scarab::search {

/// With which configuration trials are run.
enum class Fidelity {
  kSearch,  ///< with the description's overrides
  kFull,    ///< as the project's programs will run it
};

/// A description together with the files it is about.
class Problem {
 public:
  /// Reads everything and tries the ends of every interval. Throws config::Error naming the place
  /// in the description for what does not fit.
  explicit Problem(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const Description& description() const { return description_; }
  [[nodiscard]] const ParameterSpace& space() const { return space_; }
  /// The base files as they are, without override, tie or candidate.
  [[nodiscard]] const ConfigurationTree& base() const { return base_; }

  /// The base with these values of the parameters, in the order of space(), and what is tied to
  /// them.
  [[nodiscard]] ConfigurationTree tree(const std::vector<double>& values, Fidelity fidelity) const;

 private:
  std::filesystem::path file_;
  config::Document document_;
  Description description_;
  ConfigurationTree base_;
  ParameterSpace space_;
};

}  // namespace scarab::search
