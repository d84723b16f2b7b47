#pragma once

#include <cstdint>
#include <string>

/// Numbers with units, as people read them.
namespace scarab::topic {

/// With so many digits after the point: `12.50`.
std::string fixed(double value, int digits);
/// Three significant digits or all before the point: `1234`, `98.7`, `0.0123`.
std::string rounded(double value);
/// `0.5 s`.
std::string seconds_text(double seconds);
/// `870 B`, `1.23 kB`, `12.3 MB`: powers of 1000.
std::string bytes_text(double bytes);

/// `1 sample`, `2 samples`.
std::string counted(std::uint64_t count, const std::string& what);

}  // namespace scarab::topic
