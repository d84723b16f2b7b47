#include "common/runtime/tick_pacer.hpp"

namespace scarab::runtime {

void TickPacer::tick_ends(TimePoint now) {
  due_ += period_;
  if (now <= due_) return;
  overrun_.add(now - due_);
  if (now - due_ > period_) due_ = now;
}

}  // namespace scarab::runtime
