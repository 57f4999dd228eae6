// Runs the built isolux program as a user would, for tests of its exit codes and output.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace isolux::test {

struct RunResult {
  int exitCode = -1;  // 128 + n when signal n ended it
  std::string out, err;
  // Exactly one line on stderr, that of an error.
  bool isOneErrorLine() const;
};

struct RunSettings {
  std::filesystem::path program{};         // empty: the one that was built
  std::filesystem::path folder{};          // working directory; empty: a fresh one
  std::vector<std::string> environment{};  // "NAME=VALUE", beside that of the test
  std::size_t addressSpace = 0;            // bytes, 0: no limit
  std::size_t fileSize = 0;                // bytes of any file it writes, 0: no limit
  // Processes and threads, 0: no limit. The system asks nobody else's, and not root's: it runs as a user of
  // its own, and only root can start it.
  std::size_t threads = 0;
};

// Starts now, finished by wait(). Output goes to files, so nothing can block. Once it is constructed the
// process is isolux, no longer a fork of the test: what is measured or signalled is the program.
class RunningIsolux {
 public:
  explicit RunningIsolux(const std::vector<std::string>& arguments, const RunSettings& settings = {});
  ~RunningIsolux();
  RunningIsolux(const RunningIsolux&) = delete;
  RunningIsolux& operator=(const RunningIsolux&) = delete;

  void signal(int number) const;
  // Whether its supervisor stands, which takes this signal out of the system's hands.
  bool answers(int number) const;
  // Until it does, or has ended.
  void waitUntilItAnswers(int number) const;
  double processorSeconds() const;  // that the command has used so far, on all cores
  RunResult wait();

 private:
  pid_t pid_ = -1;
  std::filesystem::path logs_;
};

RunResult runIsolux(const std::vector<std::string>& arguments, const RunSettings& settings = {});

// The same within the test's own process: a tenth of the time, for the many cases of plain wrong use.
RunResult callIsolux(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

// Names of the files in a folder, hidden ones included, sorted.
std::vector<std::string> filesIn(const std::filesystem::path& folder);
std::string contentOf(const std::filesystem::path& file);

}  // namespace isolux::test
