#include "tests/support/ui/run_program.h"

#include <cstdlib>

#include <sys/wait.h>

#include "app/documents/command_text.h"

namespace isolux::test {

int runProgram(const std::string& arguments, const std::filesystem::path& folder) {
  const std::string line = "cd " + app::shellWord(folder.string()) + " && " + app::shellWord(ISOLUX_PROGRAM) +
                           " " + arguments + " >&2";
  const int status = std::system(line.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace isolux::test
