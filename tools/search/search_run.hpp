#pragma once

#include <filesystem>

#include "tools/search/problem.hpp"
#include "tools/search/run_directory.hpp"

namespace scarab::search {

struct RunOptions {
  std::filesystem::path out;
  Identity identity;
  unsigned generations = 100;
  double minutes = 0;  ///< wall clock; 0: no limit
  unsigned jobs = 1;
  bool fresh = false;
  bool quiet = false;
};

/// Searches until the number of generations or the time is reached, or goes on with the search that
/// is in the directory. Returns the program's exit code: 0 done, 130 interrupted, the checkpoint
/// being that of the last whole generation. Throws WrongDirectory, config::Error.
int run_search(const Problem& problem, const RunOptions& options);

}  // namespace scarab::search
