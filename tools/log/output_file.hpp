#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace scarab::log {

/// Writes a file that appears under its name, in the place of one that has it, when it is whole; an
/// interrupted or failed writing leaves what was there. A log is never replaced, and what is no
/// regular file, such as /dev/stdout, is written into. Throws std::invalid_argument (it is a log)
/// and std::runtime_error (cannot be written).
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace scarab::log
