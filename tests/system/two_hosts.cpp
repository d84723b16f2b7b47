#include "tests/system/two_hosts.hpp"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "tests/support/eventually.hpp"

namespace scarab::test {
namespace {

// What holds a namespace open; it ends by itself, should nobody else end it.
const Arguments kNobody = {"/bin/sleep", "900"};
// A process that enters a user namespace forgets that it is to die with the test: it is told anew.
const Arguments kDieWithTheTest = {"/usr/bin/setpriv", "--pdeathsig", "KILL"};

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

bool is_root() { return ::geteuid() == 0; }

std::filesystem::path network_of(const std::string& process) {
  std::error_code none;
  return std::filesystem::read_symlink("/proc/" + process + "/ns/net", none);
}

/// Root may go into any namespace; everybody else only by way of the user namespace around it.
Arguments enter(const ChildProcess& host) {
  Arguments command = {"/usr/bin/nsenter", "--target", std::to_string(host.pid()), "--net"};
  if (!is_root()) command = command + Arguments{"--user", "--preserve-credentials"};
  return command + kDieWithTheTest;
}

Arguments new_network() {
  Arguments command = {"/usr/bin/unshare", "--net"};
  if (!is_root()) command = command + Arguments{"--user", "--map-root-user"};
  return command + kDieWithTheTest + kNobody;
}

Host host_on_the_cable(const ChildProcess& process, TwoHosts::Multicast multicast,
                       const std::string& other) {
  Host host{enter(process), {"--interface", TwoHosts::kInterface}, true};
  if (multicast == TwoHosts::Multicast::kOff) host.bus = host.bus + Arguments{"--peers", other};
  return host;
}

}  // namespace

TwoHosts::TwoHosts(Multicast multicast)
    : first_process_(start_host(new_network(), "first", {"self"})),
      second_process_(start_host(
          is_root() ? new_network()
                    : enter(first_process_) + Arguments{"/usr/bin/unshare", "--net"} + kNobody,
          "second", {"self", std::to_string(first_process_.pid())})),
      first_(host_on_the_cable(first_process_, multicast, kSecondAddress)),
      second_(host_on_the_cable(second_process_, multicast, kFirstAddress)) {
  must(first_, {"link", "add", kInterface, "type", "veth", "peer", "name", kInterface, "netns",
                std::to_string(second_process_.pid())});
  set_up(first_, kFirstAddress, multicast);
  set_up(second_, kSecondAddress, multicast);
}

ChildProcess TwoHosts::start_host(const Arguments& command, const std::string& name,
                                  const Arguments& others) const {
  ChildProcess host(command, directory_ / name);
  const auto has_own_network = [&] {
    const auto network = network_of(std::to_string(host.pid()));
    return !network.empty() && std::none_of(others.begin(), others.end(), [&](const auto& other) {
      return network == network_of(other);
    });
  };
  eventually([&] { return !host.running() || has_own_network(); });
  if (!host.running() || !has_own_network()) {
    throw std::runtime_error(
        "this test makes network namespaces, which needs root rights or user namespaces: " +
        host.err());
  }
  return host;
}

void TwoHosts::set_up(const Host& host, const char* address, Multicast multicast) {
  must(host, {"link", "set", "lo", "up"});
  must(host, {"address", "add", std::string(address) + "/24", "dev", kInterface});
  if (multicast == Multicast::kOff) must(host, {"link", "set", kInterface, "multicast", "off"});
  must(host, {"link", "set", kInterface, "up"});
}

Finished TwoHosts::run_on(const Host& host, const Arguments& command) {
  return run(host.enter + command);
}

ChildProcess TwoHosts::start_script(const Host& host, const std::string& script,
                                    const std::filesystem::path& output) {
  const Arguments own_processes = {"/usr/bin/unshare", "--pid", "--fork", "--kill-child",
                                   "--mount-proc"};
  const std::string in_the_tree = "cd '" + source_file("").string() + "'\n" + script;
  return {host.enter + own_processes + Arguments{"/bin/sh", "-c", in_the_tree}, output};
}

void TwoHosts::pull_out(const Host& host) { must(host, {"link", "set", kInterface, "down"}); }

void TwoHosts::plug_in(const Host& host) { must(host, {"link", "set", kInterface, "up"}); }

void TwoHosts::must(const Host& host, const Arguments& ip) {
  const auto result = run_on(host, Arguments{"/sbin/ip"} + ip);
  if (result.exit_code != 0) throw std::runtime_error("ip: " + result.err);
}

}  // namespace scarab::test
