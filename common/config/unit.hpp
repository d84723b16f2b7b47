#pragma once

#include <string_view>

namespace scarab::config {

/// The unit that a key's name ends in, as it is written by hand: `kp_nm_rad` is in "N m/rad". Empty
/// if the name ends in none that is known here.
[[nodiscard]] std::string_view unit_of(std::string_view key);

}  // namespace scarab::config
