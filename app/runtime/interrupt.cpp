#include "app/runtime/interrupt.h"

#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "app/files/files.h"

namespace isolux::app {

namespace {

constexpr int graceMilliseconds = 40;

// A signal handler can reach nothing else.
std::atomic<int> signalPipe{-1};

extern "C" void isoluxOnInterrupt(int) {
  const int kept = errno;
  const char byte = 'i';
  if (const int fd = signalPipe.load(); fd >= 0) {
    const auto written = ::write(fd, &byte, 1);
    static_cast<void>(written);  // a full pipe already says it
  }
  errno = kept;
}

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (number == SIGHUP && before.sa_handler == SIG_IGN) continue;  // nohup
    sigaction(number, &action, nullptr);
  }
}

}  // namespace

InterruptWatcher::InterruptWatcher(base::Progress& progress) : progress_(progress) {
  // Without pipe or thread Ctrl-C just ends the process.
  if (::pipe2(pipe_, O_CLOEXEC | O_NONBLOCK) != 0) return;
  try {
    thread_ = std::thread([this] { watch(); });
  } catch (const std::system_error&) {
    return;
  }
  signalPipe = pipe_[1];
  handle(isoluxOnInterrupt);
}

InterruptWatcher::~InterruptWatcher() {
  if (!thread_.joinable()) return;
  handle(SIG_DFL);
  signalPipe = -1;
  ::close(pipe_[1]);  // ends the thread
  thread_.join();
  ::close(pipe_[0]);
}

void InterruptWatcher::watch() {
  const auto next = [this](int timeout) {  // 'i': a signal; 'q': the watcher goes away; 't': nothing in time
    pollfd waiting{pipe_[0], POLLIN, 0};
    int ready = 0;
    do ready = ::poll(&waiting, 1, timeout);
    while (ready < 0 && errno == EINTR);
    char byte = 'q';
    if (ready == 0) return 't';
    return ::read(pipe_[0], &byte, 1) == 1 ? byte : 'q';
  };
  if (next(-1) == 'q') return;
  progress_.requestStop();
  char event = next(graceMilliseconds);
  while (event == 'i') event = next(graceMilliseconds);  // more Ctrl-C: no reason to hurry more
  if (event == 'q') return;

  removePendingFiles();
  if (claimReport(true)) {
    constexpr std::string_view line = "isolux: interrupted\n";
    const auto written = ::write(STDERR_FILENO, line.data(), line.size());
    static_cast<void>(written);
  }
  ::_exit(static_cast<int>(base::ErrorKind::interrupted));
}

}  // namespace isolux::app
