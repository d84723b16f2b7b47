#pragma once

#include <filesystem>
#include <vector>

#include "common/mcap/reader.hpp"

namespace scarab::log {

/// Writes every attachment of a log below `folder`, which is made if need be; returns the files.
/// Throws std::runtime_error, before anything is written, for a name that would lead out of the
/// folder and where a file of other content has the name; and for one that cannot be written.
std::vector<std::filesystem::path> extract_attachments(const mcap::Reader& reader,
                                                       const std::filesystem::path& folder);

}  // namespace scarab::log
