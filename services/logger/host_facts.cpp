#include "services/logger/host_facts.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>

namespace scarab::logger {
namespace {

/// The value of the first line `key : value` of a file of /proc.
std::string first_value(const char* file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t colon = line.find(':');
    if (line.compare(0, key.size(), key) != 0 || colon == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

}  // namespace

std::string host_name() {
  struct utsname system {};
  return ::uname(&system) == 0 ? system.nodename : "";
}

mcap::Metadata host_metadata() {
  mcap::Metadata metadata{"scarab.host",
                          {{"cpu", first_value("/proc/cpuinfo", "model name")},
                           {"cpu_count", std::to_string(::sysconf(_SC_NPROCESSORS_ONLN))},
                           {"memory", first_value("/proc/meminfo", "MemTotal")},
                           {"cyclone_dds", SCARAB_CYCLONE_VERSION}}};
  struct utsname system {};
  if (::uname(&system) == 0) {
    metadata.entries["host"] = system.nodename;
    metadata.entries["kernel"] = std::string(system.sysname) + " " + system.release;
    metadata.entries["machine"] = system.machine;
  }
  for (auto entry = metadata.entries.begin(); entry != metadata.entries.end();) {
    entry = entry->second.empty() ? metadata.entries.erase(entry) : std::next(entry);
  }
  return metadata;
}

}  // namespace scarab::logger
