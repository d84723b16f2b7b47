#pragma once

namespace scarab::runtime {

/// Makes this thread, and those it starts from now on, give way: when a sample wakes them they wait
/// until a core is free (Linux: SCHED_BATCH), and who else wakes up takes the core from them at
/// once (nice 10, and a slice of 100 ms: Linux 6.12 and later; sched_setattr(2)). For a service
/// that nobody in the chain waits for: on few cores its every wake-up, and every chunk it
/// compresses, would else hold the chain up. Beside others that are always busy it gets a tenth of
/// the share of one of them. False: the system refuses, and all stays as it was.
bool be_polite();

}  // namespace scarab::runtime
