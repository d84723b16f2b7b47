#pragma once

#include <map>
#include <string>

#include "tools/search/configuration_tree.hpp"

/// Values that follow others: what one configuration file says twice, or what can be calculated.
namespace scarab::search {

/// Path -> the path whose number it takes, or the name of a function (one without a dot).
using Ties = std::map<std::string, std::string>;

/// Period in ticks of the oscillator that premotor.network.cpg describes, to 0.01: of its orbit,
/// not of its linearisation. Throws std::invalid_argument if it does not oscillate.
[[nodiscard]] double cpg_period_ticks(double w11, double w12);

/// Why a tie cannot be, in words; empty: it can. Neither its source nor a function's may be tied.
[[nodiscard]] std::string refusal_of_tie(const ConfigurationTree& tree, const Ties& ties,
                                         const std::string& path);

/// Sets every tied number. Expects that no tie is refused.
void apply_ties(ConfigurationTree& tree, const Ties& ties);

}  // namespace scarab::search
