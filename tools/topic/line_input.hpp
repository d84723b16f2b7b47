#pragma once

#include <functional>
#include <string>

namespace scarab::topic {

/// Reads standard input line by line, as it comes, and calls f with each line (without its end)
/// until f says false, the input ends, or `interrupted()`. Returns true where the input has ended.
bool read_lines(const std::function<bool()>& interrupted,
                const std::function<bool(const std::string&)>& f);

/// A whole file. Throws Failure (bad usage) naming it.
std::string read_whole(const std::string& file);

}  // namespace scarab::topic
