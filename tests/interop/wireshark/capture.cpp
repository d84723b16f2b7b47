#include "tests/interop/wireshark/capture.hpp"

#include <csignal>
#include <sstream>
#include <stdexcept>

#include "tests/support/eventually.hpp"
#include "tests/support/programs.hpp"

namespace scarab::test {
namespace {

/// The UDP ports of a domain (RTPS, 9.6.1.1).
std::string ports(std::uint32_t domain) {
  constexpr std::uint32_t kPortBase = 7400;
  constexpr std::uint32_t kDomainGain = 250;
  const std::uint32_t first = kPortBase + kDomainGain * domain;
  return "udp dst portrange " + std::to_string(first) + "-" +
         std::to_string(first + kDomainGain - 1);
}

Arguments capture_command(std::uint32_t domain, const std::filesystem::path& file) {
  return {SCARAB_TSHARK, "-q",          "-i", "lo",
          "-f",          ports(domain), "-B", "32",  // MiB
          "-a",          "duration:60", "-a", "packets:200000",
          "-w",          file};
}

bool has_bytes(const std::filesystem::path& file) {
  std::error_code absent;
  const auto size = std::filesystem::file_size(file, absent);
  return !absent && size > 0;
}

}  // namespace

Capture::Capture(std::uint32_t domain, const std::filesystem::path& file)
    : file_(file), tshark_(capture_command(domain, file), file) {
  // It opens the file when it has begun to listen.
  eventually([&] { return has_bytes(file_) || !tshark_.running(); });
  if (tshark_.running() && has_bytes(file_)) return;
  throw std::runtime_error(
      "tshark cannot capture on lo, which takes root rights, or the group wireshark where "
      "dumpcap was set up for it: " +
      tshark_.err());
}

void Capture::stop() {
  tshark_.signal(SIGINT);
  const auto code = tshark_.wait(std::chrono::seconds(10));
  if (code != 0) throw std::runtime_error("tshark did not end well: " + tshark_.err());
}

std::vector<std::string> Capture::dissect(const std::string& filter,
                                          const std::vector<std::string>& fields) const {
  Arguments command = {SCARAB_TSHARK, "-r", file_, "-Y", filter, "-T", "fields"};
  for (const std::string& field : fields) command.insert(command.end(), {"-e", field});
  const Finished result = run(command);
  if (result.exit_code != 0) throw std::runtime_error("tshark: " + result.err);
  std::vector<std::string> lines;
  std::istringstream text(result.out);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

}  // namespace scarab::test
