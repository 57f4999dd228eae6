// Opens the window: what `isolux [PATH]` does without a subcommand.
#pragma once

#include <optional>
#include <string>

#include <QApplication>

#include "app/commands/command_line.h"

namespace isolux::ui {

// An exception that leaves an event's handler, a slot, say, is told in the window, which goes on.
class Application : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;
};

// Makes the Application, shows the window and runs it until it is closed. Returns the exit code. Throws
// base::Error{graphics} when no display can be reached.
int openWindow(const app::WindowRequest& request);

// Returns how the window would show images here, or why there would be none, in a line. Creates and destroys
// a QApplication.
std::string describeWindow();

// Why no window can be shown on this machine, or nothing when one can. Asks before Qt is started, because Qt
// aborts the process when it cannot reach its display.
std::optional<std::string> displayProblem();

// What must be set before the QApplication is made (GL 4.5 core for every context), and after.
void prepareApplication();
void finishApplication();

}  // namespace isolux::ui
