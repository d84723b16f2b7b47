#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/mcap/recover.hpp"

namespace scarab::log {

/// True while a process has the file open for writing, as far as the file system tells.
bool is_being_written(const std::filesystem::path& path);

/// The name of a mended log where none is given: `trial.mcap` of `trial.mcap.active`, and
/// `trial.mended.mcap` of `trial.mcap`.
std::filesystem::path mended_name(const std::filesystem::path& cut);

/// All logs below a directory, at any depth, that were not closed, in order.
std::vector<std::filesystem::path> cut_logs(const std::filesystem::path& directory);

/// What mend() has done.
struct Mending {
  std::filesystem::path to;  ///< empty: the file is whole, there was nothing to mend
  mcap::Recovery recovery;
  bool removed = false;  ///< the cut file is gone
};

/// Makes a whole file of a cut one: `to` if given, else mended_name(), and then the cut file
/// `*.active` is removed, once the new one is on the disk, unless records in it are damaged. Throws
/// mcap::Error: the file is being written, `to` exists, ...
Mending mend(const std::filesystem::path& cut, const std::optional<std::filesystem::path>& to,
             const mcap::Progress& progress = {});

/// What was kept and what was lost, in words.
std::string to_string(const std::filesystem::path& cut, const Mending& mending);

}  // namespace scarab::log
