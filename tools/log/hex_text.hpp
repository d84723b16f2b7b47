#pragma once

#include <string>

#include "common/bus/raw_cdr.hpp"

namespace scarab::log {

/// Appends bytes as a JSON string of hexadecimal digits.
void append_hex(std::string& out, sample::ByteView bytes);

}  // namespace scarab::log
