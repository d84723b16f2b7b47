#pragma once

#include <cstdint>
#include <string>

namespace scarab::logger {

/// `2026-11-22T09:58:31Z`.
std::string utc_text(std::int64_t ns_since_epoch);
std::string utc_now();

}  // namespace scarab::logger
