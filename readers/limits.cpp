#include "readers/limits.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <ctime>
#include <fstream>

#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace isolux::readers {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;  // sanitizers reserve address space by the terabyte
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool sanitized = false;
#endif

// Never above what the user has set (a superuser could).
void setLimit(__rlimit_resource resource, rlim_t value) {
  rlimit limit{};
  ::getrlimit(resource, &limit);
  limit.rlim_cur = limit.rlim_max = std::min(value, limit.rlim_max);
  ::setrlimit(resource, &limit);
}

std::uint64_t addressBytesNow() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// The soft limit, whose signal (SIGXCPU) says what has happened.
void allowSeconds(double seconds) {
  timespec spent{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
  const double now = static_cast<double>(spent.tv_sec) + 1e-9 * static_cast<double>(spent.tv_nsec);
  rlimit limit{};
  ::getrlimit(RLIMIT_CPU, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(std::ceil(now + seconds)));
  ::setrlimit(RLIMIT_CPU, &limit);
}

}  // namespace

bool endWithParent(int parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  return ::getppid() == parent;
}

void limitReader(std::size_t budgetBytes) {
  constexpr std::uint64_t small = std::uint64_t{512} << 20, most = std::uint64_t{1} << 46;
  setLimit(RLIMIT_CORE, 0);
  std::signal(SIGXFSZ, SIG_IGN);  // a write is refused, that is enough
#ifndef ISOLUX_COVERAGE           // which lines ran is written to files
  setLimit(RLIMIT_FSIZE, 0);
#endif
  ::mallopt(M_ARENA_MAX, 2);  // each arena reserves address space
  const std::uint64_t budget = std::min<std::uint64_t>(budgetBytes, most);
  if (!sanitized) setLimit(RLIMIT_AS, addressBytesNow() + 2 * budget + budget / 2 + small);
  allowHeaders(1, 0);
}

void allowHeaders(std::size_t files, std::uint64_t fileBytes) {
  const double ofLongHeaders = std::min(2.5, 2e-6 * static_cast<double>(fileBytes));
  allowSeconds(1.5 + 0.02 * static_cast<double>(files) + ofLongHeaders);
}

void allowDecoding(std::uint64_t fileBytes) {
  allowSeconds(1.5 + 20e-6 * static_cast<double>(fileBytes));
}

}  // namespace isolux::readers
