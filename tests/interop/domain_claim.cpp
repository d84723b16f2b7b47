#include "tests/interop/domain_claim.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>

namespace scarab::test {
namespace {

bool bind_name(int socket, const std::string& name) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(&address.sun_path[1], name.data(), name.size());  // a leading 0: no file
  const auto size = offsetof(sockaddr_un, sun_path) + 1 + name.size();
  return ::bind(socket, reinterpret_cast<const sockaddr*>(&address),
                static_cast<socklen_t>(size)) == 0;
}

}  // namespace

DomainClaim::DomainClaim() : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  for (domain_ = kFirst; domain_ <= kLast; ++domain_) {
    if (bind_name(socket_, "scarab-domain-" + std::to_string(domain_))) return;
  }
  ::close(socket_);
  throw std::runtime_error("the DDS domains 150 to 169 are all in use by other tests");
}

DomainClaim::~DomainClaim() { ::close(socket_); }

Host DomainClaim::host() const { return {{}, {"--domain", std::to_string(domain_)}, true}; }

}  // namespace scarab::test
