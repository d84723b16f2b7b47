#include "common/runtime/tick_pacer.hpp"

namespace scarab::runtime {

void TickPacer::tick_begins(TimePoint now) {
  if (begun_) cycle_.add(now - *begun_);
  begun_ = now;
  jitter_.add(now - due_);
}

void TickPacer::tick_ends(TimePoint now) {
  due_ += period_;
  if (now <= due_) return;
  overrun_.add(now - due_);
  if (now - due_ > period_) due_ = now;
}

}  // namespace scarab::runtime
