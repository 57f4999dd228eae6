#include "tests/app/commands/run_isolux.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/commands/command_line.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"

namespace isolux::test {

namespace fs = std::filesystem;

bool RunResult::isOneErrorLine() const {
  return err.starts_with("isolux: ") && std::count(err.begin(), err.end(), '\n') == 1 && err.back() == '\n';
}

RunningIsolux::RunningIsolux(const std::vector<std::string>& arguments, const RunSettings& settings)
    : logs_(temporaryFolder()) {
  std::vector<std::string> words{settings.program.empty() ? ISOLUX_BINARY : settings.program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  // Its cache is the test's; the driver's shaders stay where other processes have them.
  std::vector<std::string> environment{"XDG_CACHE_HOME=" + (logs_ / "cache").string()};
  if (std::getenv("MESA_SHADER_CACHE_DIR") == nullptr) {
    const char *const cache = std::getenv("XDG_CACHE_HOME"), *const home = std::getenv("HOME");
    if (cache != nullptr || home != nullptr)
      environment.push_back("MESA_SHADER_CACHE_DIR=" + (cache ? cache : std::string(home) + "/.cache"));
  }
  environment.insert(environment.end(), settings.environment.begin(), settings.environment.end());
  const std::string folder = settings.folder.empty() ? temporaryFolder().string() : settings.folder.string();
  const std::string out = (logs_ / "out").string(), err = (logs_ / "err").string();

  int running[2] = {-1, -1};  // a pipe whose writing end closes as isolux takes the place of the test's fork
  EXPECT_EQ(::pipe2(running, O_CLOEXEC), 0);
  pid_ = ::fork();
  if (pid_ != 0) {
    ::close(running[1]);
    char nothing = 0;
    while (::read(running[0], &nothing, 1) < 0 && errno == EINTR) {
    }
    ::close(running[0]);
    return;
  }
  // The child: only what is safe between fork and exec, and putenv.
  const int outFile = ::open(out.c_str(), O_WRONLY | O_CREAT, 0600),
            errFile = ::open(err.c_str(), O_WRONLY | O_CREAT, 0600);
  if (settings.addressSpace > 0) {
    const rlimit limit{settings.addressSpace, settings.addressSpace};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  if (settings.fileSize > 0) {
    const rlimit limit{settings.fileSize, settings.fileSize};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (settings.threads > 0) {
    constexpr uid_t nobodyElse = 54321;
    const rlimit limit{settings.threads, settings.threads};
    if (::chmod(folder.c_str(), 0777) != 0 || ::setrlimit(RLIMIT_NPROC, &limit) != 0 ||
        ::setgid(nobodyElse) != 0 || ::setuid(nobodyElse) != 0)
      ::_exit(97);
  }
  for (std::string& variable : environment) ::putenv(variable.data());
  if (outFile < 0 || errFile < 0 || ::dup2(outFile, 1) < 0 || ::dup2(errFile, 2) < 0 ||
      ::chdir(folder.c_str()) != 0)
    ::_exit(99);
  ::execv(argv[0], argv.data());
  ::_exit(98);
}

RunningIsolux::~RunningIsolux() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  wait();
}

void RunningIsolux::signal(int number) const {
  ::kill(pid_, number);
}

double RunningIsolux::processorSeconds() const {
  // The supervisor takes next to nothing; the command is its child.
  const std::string self = std::to_string(pid_);
  std::ifstream children("/proc/" + self + "/task/" + self + "/children");
  pid_t command = -1;
  clockid_t clock{};
  timespec used{};
  if (!(children >> command) || ::clock_getcpuclockid(command, &clock) != 0 ||
      ::clock_gettime(clock, &used) != 0)
    return 0.0;
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

namespace {

enum class Answer { yes, no, ended };

Answer answerOf(pid_t pid, int number) {
  const std::string text = contentOf("/proc/" + std::to_string(pid) + "/status");
  const auto caught = text.find("SigCgt:");
  if (caught == std::string::npos || text.find("State:\tZ") != std::string::npos) return Answer::ended;
  const bool stands = (std::strtoull(text.c_str() + caught + 7, nullptr, 16) >> (number - 1) & 1) != 0;
  return stands ? Answer::yes : Answer::no;
}

}  // namespace

bool RunningIsolux::answers(int number) const {
  return answerOf(pid_, number) == Answer::yes;
}

void RunningIsolux::waitUntilItAnswers(int number) const {
  EXPECT_TRUE(pollUntil([&] { return answerOf(pid_, number) != Answer::no; }));
}

RunResult RunningIsolux::wait() {
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contentOf(logs_ / "out"),
          contentOf(logs_ / "err")};
}

RunResult runIsolux(const std::vector<std::string>& arguments, const RunSettings& settings) {
  return RunningIsolux(arguments, settings).wait();
}

RunResult callIsolux(const std::vector<std::string>& arguments, const fs::path& folder) {
  std::vector<std::string> words{"isolux"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  RunResult result;
  result.exitCode =
      app::runCommandLine(static_cast<int>(argv.size()), argv.data(), [](const app::WindowRequest&) {
        ADD_FAILURE() << "the window was opened";
        return 0;
      });
  std::fflush(stdout);
  result.out = testing::internal::GetCapturedStdout();
  result.err = testing::internal::GetCapturedStderr();
  fs::current_path(before);
  return result;
}

std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream content;
  content << stream.rdbuf();
  return content.str();
}

}  // namespace isolux::test
