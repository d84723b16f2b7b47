#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "common/runtime/options.hpp"

/// What scarab-topic does; each prints to standard output and returns the program's exit code. They
/// need a runtime::SignalBlock made before and throw bus::Error for what goes wrong.
namespace scarab::topic {

struct ListOptions {
  std::chrono::milliseconds timeout{1000};
  bool verbose = false;
};

/// One line a topic: type, writers, readers.
int list(const runtime::BusOptions& bus_options, const ListOptions& options);

struct EchoOptions {
  std::string topic;
  std::chrono::milliseconds timeout{2000};  ///< how long to wait for a writer
  std::uint64_t count = 0;                  ///< samples; 0: until Ctrl-C
  bool json = false;
};

/// Every sample of a topic, as YAML documents or as lines of JSON.
int echo(const runtime::BusOptions& bus_options, const EchoOptions& options);

/// The rate of a topic, a line a second; `count` lines.
int rate(const runtime::BusOptions& bus_options, const EchoOptions& options);

}  // namespace scarab::topic
