// `isolux`: opens the window by becoming isolux-program, or runs a command in a child process and watches
// over it, so that an interrupt is answered within 100 ms from the first instruction on, whatever the command
// is doing: loading libraries, compiling shaders in a driver, giving gigabytes back to the system.
//
// SIGINT, SIGTERM and SIGHUP are passed on; a command that listens ends by itself (app/runtime/interrupt.h).
// One that has not after kGraceMilliseconds is killed with all that it has started, its unfinished files are
// removed (base/supervision_board.h), and the exit code is 130. Unfinished files of a command that crashes go
// too.
//
// A static program without libraries: it is at work a millisecond after the shell has started it.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include <dirent.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <climits>
#include <csignal>

#include "app/launcher/command_names.h"
#include "base/supervision_board.h"

namespace {

using isolux::base::SupervisionBoard;
using Slot = SupervisionBoard::Slot;

constexpr int kInterrupted = 130;
constexpr long kGraceMilliseconds = 45;  // five more than app/runtime/interrupt.cpp gives a job
constexpr long kBurialMilliseconds = 15;
constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

extern "C" void nothing(int) {}

void say(const char* text) {
  const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
  static_cast<void>(written);
}

[[noreturn]] void fail(const char* reason) {
  say("isolux: ");
  say(reason);
  say("\n");
  ::_exit(1);
}

// isolux-program: in the folder of this program where it was built, in ../libexec/isolux where it is
// installed.
void findProgram(char (&path)[PATH_MAX]) {
  constexpr char beside[] = "isolux-program", installed[] = "../libexec/isolux/isolux-program";
  const ssize_t length = ::readlink("/proc/self/exe", path, sizeof path - sizeof installed);
  if (length <= 0) fail("cannot find its own folder: is /proc mounted?");
  path[length] = '\0';
  char* const name = std::strrchr(path, '/') + 1;
  std::memcpy(name, beside, sizeof beside);
  if (::access(path, X_OK) != 0) std::memcpy(name, installed, sizeof installed);
}

bool isCommand(const char* word) {
  for (const char* const name : isolux::app::kCommandNames)
    if (std::strcmp(word, name) == 0) return true;
  return false;
}

// Whether the word behind it is its value.
bool isOption(const char* word) {
  return std::strncmp(word, "--", 2) == 0 && !std::strchr(word, '=');
}

// Everything else opens the window.
bool runsCommand(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (isCommand(argv[i]) && (i == 1 || !isOption(argv[i - 1]))) return true;
  return false;
}

// Where a standard descriptor is closed, the next file that is opened would take its number, and with it all
// that is printed.
void fillStandardDescriptors() {
  int file = 0;
  do file = ::open("/dev/null", O_RDWR);
  while (file >= 0 && file <= STDERR_FILENO);
  if (file > STDERR_FILENO) ::close(file);
}

SupervisionBoard* shareBoard() {
  const int file = ::memfd_create("isolux-supervision", 0);
  const auto before = std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes holds for this one, too
  const bool sized = file >= 0 && ::ftruncate(file, sizeof(SupervisionBoard)) == 0;
  std::signal(SIGXFSZ, before);
  if (!sized) return nullptr;
  void* const memory = ::mmap(nullptr, sizeof(SupervisionBoard), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (memory == MAP_FAILED) return nullptr;
  char number[16];
  std::snprintf(number, sizeof number, "%d", file);
  ::setenv(isolux::base::kBoardVariable, number, 1);
  return new (memory) SupervisionBoard;  // zeros: nothing announced
}

// Children of all threads of a process; calls each(pid).
template <class Each>
void forEachChild(pid_t parent, const Each& each) {
  char path[64];
  std::snprintf(path, sizeof path, "/proc/%d/task", parent);
  DIR* const tasks = ::opendir(path);
  if (!tasks) return;
  while (const dirent* task = ::readdir(tasks)) {
    if (task->d_name[0] == '.') continue;
    char children[128];
    std::snprintf(children, sizeof children, "/proc/%d/task/%.20s/children", parent, task->d_name);
    FILE* const list = std::fopen(children, "re");
    if (!list) continue;
    int pid = 0;
    while (std::fscanf(list, "%d", &pid) == 1) each(pid);
    std::fclose(list);
  }
  ::closedir(tasks);
}

void killOrphans() {
  forEachChild(::getpid(), [](pid_t child) { ::kill(child, SIGKILL); });
}

// The command first, so that it starts nothing more; what it has started becomes a child of this process
// then.
void killWithDescendants(pid_t pid) {
  pid_t descendants[256];
  int count = 0;
  descendants[count++] = pid;
  for (int next = 0; next < count; ++next)
    forEachChild(descendants[next], [&](pid_t child) {
      if (count < 256) descendants[count++] = child;
    });
  for (int i = 0; i < count; ++i) ::kill(descendants[i], SIGKILL);
  killOrphans();
}

class Supervisor {
 public:
  // The mask first: an interrupt that comes from now on waits until there is something to answer with.
  Supervisor() {
    sigemptyset(&wanted_);
    sigaddset(&wanted_, SIGCHLD);
    for (const int number : kSignals) sigaddset(&wanted_, number);
    sigprocmask(SIG_BLOCK, &wanted_, &before_);
    std::signal(SIGCHLD, SIG_DFL);
    for (const int number : kSignals)
      if (std::signal(number, nothing) == SIG_IGN && number == SIGHUP) {  // nohup
        std::signal(SIGHUP, SIG_IGN);
        sigdelset(&wanted_, SIGHUP);
      }
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    board_ = shareBoard();
  }

  void start(const char* program, char** arguments) {
    const pid_t self = ::getpid();
    command_ = ::fork();
    if (command_ < 0) fail("cannot create a process; raise the process limit (ulimit -u)");
    if (command_ > 0) return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody is left without its supervisor
    if (::getppid() != self) ::_exit(kInterrupted);
    sigprocmask(SIG_SETMASK, &before_, nullptr);
    ::execv(program, arguments);
    fail("cannot start isolux-program; expected next to isolux or in ../libexec/isolux");
  }

  int watch() {
    for (;;) {
      const int signal = next(-1);
      if (signal == SIGCHLD) {
        if (ended()) return answer();
      } else if (signal > 0) {
        return interrupt(signal);
      }
    }
  }

 private:
  // The next signal; 0 at the timeout (milliseconds, -1: never).
  int next(long milliseconds) {
    const timespec time{milliseconds / 1000, milliseconds % 1000 * 1000000};
    const int signal =
        milliseconds < 0 ? ::sigwaitinfo(&wanted_, nullptr) : ::sigtimedwait(&wanted_, nullptr, &time);
    return signal > 0 ? signal : 0;
  }

  // Reaps whatever has ended; true: the command has.
  bool ended() {
    int status = 0;
    for (pid_t pid; (pid = ::waitpid(-1, &status, WNOHANG)) > 0;)
      if (pid == command_) {
        status_ = status;
        return true;
      }
    return false;
  }

  static long now() {
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1000 + time.tv_nsec / 1000000;
  }

  bool endsWithin(long milliseconds) {
    for (const long end = now() + milliseconds; now() < end;) {
      if (ended()) return true;
      if (next(end - now()) == 0) break;
    }
    return ended();
  }

  int interrupt(int signal) {
    ::kill(command_, signal);
    if (endsWithin(kGraceMilliseconds)) return answer();
    killWithDescendants(command_);
    removeUnfinished();
    // A thread that was inside a system call finishes that first; a process of gigabytes is not waited for.
    endsWithin(kBurialMilliseconds);
    killOrphans();
    removeUnfinished();
    reportInterrupt();
    return kInterrupted;
  }

  // The command's exit code as this program's.
  int answer() {
    if (WIFEXITED(status_)) {
      if (WEXITSTATUS(status_) == kInterrupted) reportInterrupt();
      return WEXITSTATUS(status_);
    }
    killWithDescendants(command_);
    removeUnfinished();
    const int signal = WTERMSIG(status_);
    for (const int number : kSignals)
      if (signal == number) {
        reportInterrupt();
        return kInterrupted;
      }
    const rlimit noCore{0, 0};  // the command has left one
    ::setrlimit(RLIMIT_CORE, &noCore);
    std::signal(signal, SIG_DFL);
    ::raise(signal);
    return 128 + signal;
  }

  void removeUnfinished() {
    if (!board_) return;
    for (Slot& slot : board_->slots)
      if (slot.state.load() == Slot::announced) {
        slot.path[sizeof slot.path - 1] = '\0';
        ::unlink(slot.path);
      }
  }

  void reportInterrupt() {
    if (!board_ || board_->reported.exchange(1) == 0) say("isolux: interrupted\n");
  }

  SupervisionBoard* board_ = nullptr;
  sigset_t wanted_{}, before_{};
  pid_t command_ = -1;
  int status_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  char program[PATH_MAX];
  fillStandardDescriptors();
  if (!runsCommand(argc, argv)) {
    findProgram(program);
    ::execv(program, argv);
    fail("cannot start isolux-program; expected next to isolux or in ../libexec/isolux");
  }
  Supervisor supervisor;
  findProgram(program);
  supervisor.start(program, argv);
  ::_exit(supervisor.watch());
}
