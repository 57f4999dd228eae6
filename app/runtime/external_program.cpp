#include "app/runtime/external_program.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t keptOutput = std::size_t{64} << 10;
constexpr int pollMilliseconds = 20;

struct Spawned {
  pid_t pid = -1;
  int output = -1;  // read end
};

Spawned spawn(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& folder) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {};
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t pid = -1;
  const int failed = ::posix_spawn(&pid, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (failed == 0) return {pid, ends[0]};
  ::close(ends[0]);
  return {};
}

int exitCodeOf(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::string ProgramResult::lastLine() const {
  const std::string text = output.substr(0, output.find_last_not_of(" \n\r\t") + 1);
  return text.substr(text.rfind('\n') + 1);
}

fs::path findProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder.empty() ? "." : folder) / name;
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored) && ::access(candidate.c_str(), X_OK) == 0)
      return fs::absolute(candidate, ignored);
  }
  return {};
}

ProgramResult runProgram(const fs::path& program, const std::vector<std::string>& arguments,
                         const fs::path& folder, const base::Progress& progress) {
  ProgramResult result;
  const Spawned child = spawn(program, arguments, folder);
  if (child.pid < 0) return result;
  char buffer[4096];
  for (;;) {
    if (progress.stopRequested()) {
      ::kill(child.pid, SIGKILL);
      ::close(child.output);
      exitCodeOf(child.pid);
      progress.throwIfStopped();
    }
    pollfd waiting{child.output, POLLIN, 0};
    if (::poll(&waiting, 1, pollMilliseconds) <= 0) continue;
    const ssize_t bytes = ::read(child.output, buffer, sizeof buffer);
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes <= 0) break;
    result.output.append(buffer, static_cast<std::size_t>(bytes));
    if (result.output.size() > keptOutput) result.output.erase(0, result.output.size() - keptOutput);
  }
  ::close(child.output);
  result.exitCode = exitCodeOf(child.pid);
  return result;
}

}  // namespace isolux::app
