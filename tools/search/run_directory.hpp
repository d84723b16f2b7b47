#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/search/problem.hpp"

/// What a search keeps in its output directory.
namespace scarab::search {

/// What makes a search the one it is: a directory holds one of them.
struct Identity {
  std::uint64_t seed = 1;
  unsigned islands = 1;
  std::filesystem::path file;  ///< the description, absolute; not compared: it may be moved
};

/// Costs of one generation: [island][candidate].
using GenerationCosts = std::vector<std::vector<double>>;

/// The best found so far on the validation seeds.
struct Winner {
  unsigned generation = 0;  ///< 0: the base itself
  double objective = 0;
  double start_objective = 0;  ///< of the base
  std::vector<double> values;  ///< in the order of the parameter space
};

/// The directory is of another search, or no search. what() is one line that names what differs.
class WrongDirectory : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Files of a search: `identity/` (description, base files, seed), `costs.csv` (all that the
/// optimiser was told: the checkpoint), `history.csv`, `winner.yaml`. Each is written under another
/// name and then renamed, so that none is ever half there.
class RunDirectory {
 public:
  explicit RunDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Takes possession: empties it of a search if `fresh`, makes it if it is not there, and writes
  /// down the identity, or compares it with the one that is there. Throws WrongDirectory.
  void claim(const Problem& problem, const Identity& identity, bool fresh) const;
  /// Of the search that is here. Throws WrongDirectory if there is none.
  [[nodiscard]] Identity identity() const;
  /// The base files as they were when it began.
  [[nodiscard]] ConfigurationTree base() const;

  [[nodiscard]] std::vector<GenerationCosts> read_costs() const;
  void write_costs(const std::vector<GenerationCosts>& costs) const;
  [[nodiscard]] std::optional<Winner> read_winner(const ParameterSpace& space) const;
  void write_winner(const Winner& winner, const ParameterSpace& space) const;

  /// Replaces a file as a whole.
  void write(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::optional<std::string> read(const std::string& name) const;

 private:
  void expect_description(const Problem& problem) const;

  std::filesystem::path path_;
};

}  // namespace scarab::search
