// Whether a call waits, told by a count and not by a clock.
#pragma once

#include <sys/resource.h>

namespace isolux::test {

// How often the calling thread gives up the processor of its own accord while it runs `action`: each wait for
// a lock, a thread or a file that is not ready is one. What other programs take away is counted elsewhere, so
// the load of the machine does not change it. Now and then the system itself lets a thread wait (for the
// lock of its memory map): take the least of several. Sanitizers wait themselves, for a thread that they
// start: with them nothing is counted.
template <class Action>
long ownWaits(const Action& action) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  action();
  return 0;
#else
  rusage before{}, after{};
  ::getrusage(RUSAGE_THREAD, &before);
  action();
  ::getrusage(RUSAGE_THREAD, &after);
  return after.ru_nvcsw - before.ru_nvcsw;
#endif
}

}  // namespace isolux::test
