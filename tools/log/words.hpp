#pragma once

#include <cstdint>
#include <string>

namespace scarab::log {

/// `2026-11-22 12:04:01.500 UTC` of ns since the Unix epoch.
std::string utc_text(std::uint64_t time_ns);

/// `17.3 MB`.
std::string size_text(std::uint64_t bytes);

/// `1 message`, `2 messages`.
std::string counted(std::uint64_t number, const std::string& noun);

/// A number with so many digits after the point.
std::string fixed_text(double value, int digits);

}  // namespace scarab::log
