// The isolux program: the command line decides; the window is one of the things it can do.
#include <cstdio>
#include <cstdlib>

#include "app/commands/command_line.h"
#include "app/runtime/last_resort.h"
#include "app/runtime/program_store.h"
#include "base/destroy_in_background.h"
#include "ui/window/application.h"

#ifdef __linux__
// Before the constructors of libraries, which may want more memory than there is.
__attribute__((section(".preinit_array"),
               used)) static void (*const beforeAll)() noexcept = isolux::app::installLastResort;
#endif

int main(int argc, char** argv) {
  constexpr double secondsToEnd = 1.0;
  isolux::app::storePrograms();
  const int exitCode =
      isolux::app::runCommandLine(argc, argv, isolux::ui::openWindow, isolux::ui::describeWindow);
  if (isolux::base::awaitDestroyed(secondsToEnd)) return exitCode;
  // A thread is stuck, perhaps in a read from a dead disk: it must not see the program's statics go.
  std::fflush(nullptr);
  std::_Exit(exitCode);
}
