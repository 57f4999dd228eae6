// The isolux program: the command line decides; the window is one of the things it can do.
#include "app/command_line.h"
#include "ui/open_window.h"

int main(int argc, char** argv) {
  return isolux::app::runCommandLine(argc, argv, isolux::ui::openWindow);
}
