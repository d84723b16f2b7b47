#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/search/problem.hpp"
#include "tools/search/run_directory.hpp"

namespace scarab::search {

/// Writes the winner of the search in `directory` into the base files, or into files of the same
/// names below `to`/KIND/ if that is given: only the numbers that change, and a block of comments
/// that says where they are from. Returns what was written. Throws WrongDirectory if there is no
/// winner, or if the base files have since changed in anything else but what was searched for.
std::vector<std::filesystem::path> write_winner(const Problem& problem,
                                                const RunDirectory& directory,
                                                const std::filesystem::path& to);

/// Lines of comment: which search, how far it went, what it reached.
[[nodiscard]] std::vector<std::string> provenance(const Problem& problem,
                                                  const RunDirectory& directory,
                                                  const Winner& winner);

}  // namespace scarab::search
