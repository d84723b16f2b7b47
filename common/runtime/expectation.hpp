#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace scarab::runtime {

/// How many instances of each service the stack has, by service name; from stack.yaml.
using Expectation = std::map<std::string, std::uint32_t>;

/// Reads `plant=1,premotor=2`. Throws std::invalid_argument naming the part that is wrong.
Expectation parse_expectation(std::string_view text);

}  // namespace scarab::runtime
