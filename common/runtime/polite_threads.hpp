#pragma once

namespace scarab::runtime {

/// Makes this thread, and those it starts from now on, wait until a core is free rather than push
/// aside who runs there when a sample wakes them (Linux: SCHED_BATCH). Their share of the processor
/// stays the same. For a service that nobody in the chain waits for: on few cores its every wake-up
/// would else hold the chain up. False: the system refuses, and all stays as it was.
bool be_polite();

}  // namespace scarab::runtime
