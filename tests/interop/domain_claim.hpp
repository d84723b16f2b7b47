#pragma once

#include <cstdint>

#include "tests/support/programs.hpp"

namespace scarab::test {

/// A DDS domain of this machine that nobody else has: other vendors know no discovery tags. Held as
/// an abstract socket of the name the launcher uses, too, so it ends with the process at the
/// latest.
class DomainClaim {
 public:
  static constexpr std::uint32_t kFirst = 150;
  static constexpr std::uint32_t kLast = 169;

  /// The lowest that is free. Throws std::runtime_error if there is none.
  DomainClaim();
  DomainClaim(const DomainClaim&) = delete;
  DomainClaim& operator=(const DomainClaim&) = delete;
  ~DomainClaim();

  [[nodiscard]] std::uint32_t domain() const { return domain_; }
  /// This host, for programs that are to meet on the domain.
  [[nodiscard]] Host host() const;

 private:
  int socket_ = -1;
  std::uint32_t domain_ = 0;
};

}  // namespace scarab::test
