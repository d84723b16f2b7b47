// Preloaded into one process: as soon as the file SCARAB_TEST_JUMP exists, its system clock is 90 s
// ahead. Deadlines of waits, which the kernel still measures by the true clock, are moved back.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

static const time_t kJumpS = 90;

typedef int (*GetTime)(clockid_t, struct timespec*);
typedef int (*TimedWait)(pthread_cond_t*, pthread_mutex_t*, const struct timespec*);

static int jumped(void) {
  const char* file = getenv("SCARAB_TEST_JUMP");
  return file != NULL && access(file, F_OK) == 0;
}

int clock_gettime(clockid_t clock, struct timespec* time) {
  const int code = ((GetTime)dlsym(RTLD_NEXT, "clock_gettime"))(clock, time);
  if (code == 0 && clock == CLOCK_REALTIME && jumped()) time->tv_sec += kJumpS;
  return code;
}

int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                           const struct timespec* until) {
  struct timespec time = *until;
  if (jumped()) time.tv_sec -= kJumpS;
  return ((TimedWait)dlvsym(RTLD_NEXT, "pthread_cond_timedwait", "GLIBC_2.3.2"))(condition, mutex,
                                                                                 &time);
}
