#include "tests/support/ui/crash_trace.h"

#include <csignal>
#include <initializer_list>

#include <execinfo.h>
#include <unistd.h>

namespace isolux::test {

namespace {

constexpr int kMostCalls = 64;

void printCalls(int signal) {
  void* calls[kMostCalls];
  backtrace_symbols_fd(calls, backtrace(calls, kMostCalls), STDERR_FILENO);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void traceCrashes() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  void* calls[1];
  backtrace(calls, 1);  // loads what it needs: a handler must not allocate
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) std::signal(signal, printCalls);
#endif
}

}  // namespace isolux::test
