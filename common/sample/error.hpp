#pragma once

#include <stdexcept>

namespace scarab::sample {

/// What bytes, a type, an expression or a value is not fit for; what() says why, in one line. The
/// errors of the bus are of this class too.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace scarab::sample
