#pragma once

#include <string>

#include "tools/search/description.hpp"

namespace scarab::search {

/// A description that is right, of the shipped beetle; `from` is replaced by `to` in it. Throws
/// std::invalid_argument if `from` is not there.
std::string description_text(const std::string& from = "", const std::string& to = "");

Description description_from(const std::string& text);

}  // namespace scarab::search
