#include "app/runtime/last_resort.h"

#include <atomic>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/resource.h>
#endif

#include "app/files/files.h"
#include "app/runtime/thread_limit.h"
#include "base/error.h"

namespace isolux::app {

namespace {

struct Ending {
  std::string_view line;
  int exitCode;
};

// Nothing here allocates, because there may be no memory.
Ending endingOf(const std::exception_ptr& thrown) {
  constexpr int memory = static_cast<int>(base::ErrorKind::memory);
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    return {"isolux: not enough memory\n", memory};
  } catch (const std::system_error&) {
    return {"isolux: the system provides no more threads or memory; raise the limits (ulimit -u)\n", memory};
  } catch (const base::Error& error) {
    if (error.kind() == base::ErrorKind::memory) return {"isolux: not enough memory\n", memory};
  } catch (const std::exception& error) {
    if (refusesThreads(error))
      return {"isolux: the system provides no more threads or memory; raise the limits (ulimit -u)\n",
              memory};
  } catch (...) {
  }
  return {"isolux: internal error: unhandled exception; please report it with the command line\n", 1};
}

[[noreturn]] void endWithOneLine() {
  static std::atomic<bool> begun{false};
  const Ending ending = endingOf(std::current_exception());
  if (!begun.exchange(true)) {  // else another thread says it, or what follows has failed, too
    const auto written = ::write(STDERR_FILENO, ending.line.data(), ending.line.size());
    static_cast<void>(written);
    removePendingFiles();
  }
  ::_exit(ending.exitCode);
}

}  // namespace

void installLastResort() noexcept {
  std::set_terminate(endWithOneLine);
#ifdef __GLIBC__
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace isolux::app
