#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace scarab::logger {

/// A topic of the chain that a service writes, so that the recorder must be matched to it before a
/// trial starts.
struct ChainWriter {
  std::string topic;
  std::string service;
  std::uint32_t count = 0;  ///< instances of the service
};

/// The writers to wait for when `expected` (instances by service name) make up the stack. Services
/// that write no topic of the chain need no waiting for.
std::vector<ChainWriter> chain_writers(const std::map<std::string, std::uint32_t>& expected);

}  // namespace scarab::logger
