#pragma once

#include <string>

#include "common/bus/raw_cdr.hpp"

namespace scarab::log {

/// The bytes of base64 text (RFC 4648). Throws bus::Error for text that is none.
sample::Bytes base64_bytes(const std::string& text);

}  // namespace scarab::log
