#pragma once

#include <filesystem>
#include <string>

#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"

namespace scarab::test {

/// Two hosts with a cable between them: network namespaces of two processes of the test, and a veth
/// pair. All of it is gone with those processes, which the kernel ends with the test.
class TwoHosts {
 public:
  enum class Multicast { kOn, kOff };

  static constexpr const char* kInterface = "cable";  ///< on both
  static constexpr const char* kFirstAddress = "10.99.0.1";
  static constexpr const char* kSecondAddress = "10.99.0.2";

  /// Without multicast the programs get each other's addresses. Throws std::runtime_error with a
  /// sentence a person can act on where the kernel allows no such thing.
  explicit TwoHosts(Multicast multicast);

  [[nodiscard]] const Host& first() const { return first_; }
  [[nodiscard]] const Host& second() const { return second_; }

  /// Runs a command on a host to its end.
  static Finished run_on(const Host& host, const Arguments& command);
  /// Starts a shell script on a host, in the root of the source tree. It sees no processes but its
  /// own; all of those, daemons too, end with it.
  static ChildProcess start_script(const Host& host, const std::string& script,
                                   const std::filesystem::path& output);

  /// Pulls the cable out of a host, whose interface is down then; the other's has no carrier.
  static void pull_out(const Host& host);
  static void plug_in(const Host& host);

 private:
  [[nodiscard]] ChildProcess start_host(const Arguments& command, const std::string& name,
                                        const Arguments& others) const;
  static void set_up(const Host& host, const char* address, Multicast multicast);
  static void must(const Host& host, const Arguments& ip);

  TemporaryDirectory directory_;
  ChildProcess first_process_;
  ChildProcess second_process_;
  Host first_;
  Host second_;
};

}  // namespace scarab::test
