#pragma once

#include <filesystem>
#include <vector>

#include "common/mcap/records.hpp"

namespace scarab::logger {

/// A file's content under `name`, with its time of change. Throws std::runtime_error when it cannot
/// be read.
mcap::Attachment load_attachment(const std::filesystem::path& file, const std::string& name);

/// Everything to be put into a log at its start: `files` under their own names, and every file in
/// `<run_dir>/config` as `config/<path>`; sorted by name within each. `run_dir` may be empty.
std::vector<mcap::Attachment> load_attachments(const std::vector<std::filesystem::path>& files,
                                               const std::filesystem::path& run_dir);

}  // namespace scarab::logger
