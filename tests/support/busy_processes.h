// Other people's work, for tests of what holds beside it.
#pragma once

#include <vector>

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

namespace isolux::test {

// A process for each core that this one may use, pinned to it and never idle.
class BusyProcesses {
 public:
  BusyProcesses() {
    cpu_set_t allowed;
    sched_getaffinity(0, sizeof allowed, &allowed);
    for (int core = 0; core < CPU_SETSIZE; ++core)
      if (CPU_ISSET(core, &allowed)) start(core);
  }
  ~BusyProcesses() {
    for (const pid_t pid : pids_) ::kill(pid, SIGKILL);
    for (const pid_t pid : pids_) ::waitpid(pid, nullptr, 0);
  }
  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses& operator=(const BusyProcesses&) = delete;
  int count() const { return static_cast<int>(pids_.size()); }

 private:
  void start(int core) {
    const pid_t pid = ::fork();
    if (pid > 0) pids_.push_back(pid);
    if (pid != 0) return;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    sched_setaffinity(0, sizeof one, &one);
    ::alarm(60);  // if the test is killed
    for (volatile bool forever = true; forever;) {
    }
  }
  std::vector<pid_t> pids_;
};

}  // namespace isolux::test
