// The isolux program: the command line decides; the window is one of the things it can do.
#include "app/command_line.h"
#include "app/last_resort.h"
#include "ui/open_window.h"

#ifdef __linux__
// Before the constructors of libraries, which may want more memory than there is.
__attribute__((section(".preinit_array"),
               used)) static void (*const beforeAll)() noexcept = isolux::app::installLastResort;
#endif

int main(int argc, char** argv) {
  return isolux::app::runCommandLine(argc, argv, isolux::ui::openWindow);
}
