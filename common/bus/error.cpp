#include "common/bus/error.hpp"

#include <dds/dds.h>

namespace scarab::bus {

int check(int code, const std::string& context) {
  if (code >= 0) return code;
  throw Error(context + ": " + dds_strretcode(code));
}

}  // namespace scarab::bus
