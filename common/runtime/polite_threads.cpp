#include "common/runtime/polite_threads.hpp"

#include <sched.h>

namespace scarab::runtime {

bool be_polite() {
  const sched_param parameters{};
  constexpr int kThisThread = 0;
  return sched_setscheduler(kThisThread, SCHED_BATCH, &parameters) == 0;
}

}  // namespace scarab::runtime
