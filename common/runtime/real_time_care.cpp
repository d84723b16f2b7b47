#include "common/runtime/real_time_care.hpp"

#include <linux/capability.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace scarab::runtime {
namespace {

// Above everything ordinary, below the kernel's own threads (50).
constexpr int kPriority = 20;

/// Whether the limit on locked memory does not count for this process.
bool may_lock_beyond_limit() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct data[_LINUX_CAPABILITY_U32S_3]{};
  return syscall(SYS_capget, &header, data) == 0 && (data[0].effective & (1U << CAP_IPC_LOCK)) != 0;
}

/// Empty: it is locked. Not tried under a limit: what goes beyond it later could not be allocated.
std::string lock_memory() {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  if (limit.rlim_cur != RLIM_INFINITY && !may_lock_beyond_limit()) {
    return "memory is not locked: the limit memlock (ulimit -l) is " +
           std::to_string(limit.rlim_cur / 1024) + " kB; make it unlimited";
  }
  // Pages are locked as they come into use: whole thread stacks would be 8 MB each.
  if (mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0) {
    return std::string("memory is not locked: ") + std::strerror(errno);
  }
  return "";
}

std::string raise_priority() {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  if (error != 0) {
    return std::string("priority is not raised: ") + std::strerror(error) +
           "; make the limit rtprio (ulimit -r) " + std::to_string(kPriority) + " or more";
  }
  return "";
}

}  // namespace

RealTimeCare take_real_time_care() {
  RealTimeCare care;
  care.memory_refusal = lock_memory();
  care.memory_locked = care.memory_refusal.empty();
  care.priority_refusal = raise_priority();
  care.priority_raised = care.priority_refusal.empty();
  return care;
}

}  // namespace scarab::runtime
