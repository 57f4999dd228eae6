// Waits for work on other threads while the window goes on living: a dialog with progress, time left and
// Cancel comes up where it takes noticeable time.
#pragma once

#include <functional>

#include <QString>

class QWidget;

namespace isolux::ui {

struct Waiting {
  QString what;                           // "Saving skull.png"
  std::function<bool()> done;             // asked every few milliseconds
  std::function<double()> fraction = {};  // in [0, 1]; none: nobody knows
  std::function<void()> cancel = {};      // asks the work to stop; done() is waited for all the same
};
// Returns when done() holds, or when the program ends. `window` takes no input meanwhile.
void waitFor(QWidget* window, const Waiting& waiting);

}  // namespace isolux::ui
