#include "ui/widgets/waiting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QElapsedTimer>
#include <QEventLoop>
#include <QGuiApplication>
#include <QProgressDialog>
#include <QTimer>

#include "ui/widgets/time_left.h"

namespace isolux::ui {

namespace {

constexpr int waitPollMilliseconds = 10, quietMilliseconds = 400, waitSteps = 1000;

// Runs the event loop until `ended` holds.
void runUntil(const std::function<bool()>& ended, QEventLoop::ProcessEventsFlags flags) {
  QEventLoop loop;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
    if (ended()) loop.quit();
  });
  timer.start(waitPollMilliseconds);
  loop.exec(flags);
}

void waitWithDialog(QWidget* window, const Waiting& waiting) {
  QProgressDialog dialog(waiting.what, waiting.cancel ? QObject::tr("Cancel") : QString(), 0,
                         waiting.fraction ? waitSteps : 0, window);
  dialog.setObjectName("waiting");
  dialog.setWindowTitle("Isolux");
  dialog.setWindowModality(Qt::WindowModal);
  dialog.setMinimumDuration(std::numeric_limits<int>::max());  // it is shown here
  dialog.setAutoClose(false);
  dialog.setAutoReset(false);
  dialog.setMinimumWidth(360);
  bool stopping = false;
  QObject::connect(&dialog, &QProgressDialog::canceled, &dialog, [&] {
    if (!waiting.cancel || std::exchange(stopping, true)) return;
    waiting.cancel();
    dialog.setLabelText(QObject::tr("Stopping…"));
    dialog.show();
  });
  dialog.show();
  TimeLeft left;
  left.begin();
  runUntil(
      [&] {
        if (waiting.done()) return true;
        if (!waiting.fraction || stopping) return false;
        const double fraction = std::clamp(waiting.fraction(), 0.0, 1.0);
        const QString rest = left.text(fraction);
        dialog.setMaximum(fraction > 0.0 ? waitSteps : 0);  // a bar that runs where nobody knows yet
        dialog.setValue(static_cast<int>(std::lround(fraction * waitSteps)));
        dialog.setLabelText(rest.isEmpty() ? waiting.what : QString("%1 · %2").arg(waiting.what, rest));
        return false;
      },
      QEventLoop::AllEvents);
}

}  // namespace

void waitFor(QWidget* window, const Waiting& waiting) {
  QElapsedTimer since;
  since.start();
  bool done = false;
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  runUntil([&] { return (done = waiting.done()) || since.elapsed() > quietMilliseconds; },
           QEventLoop::ExcludeUserInputEvents);
  QGuiApplication::restoreOverrideCursor();
  if (!done && since.elapsed() > quietMilliseconds) waitWithDialog(window, waiting);
}

}  // namespace isolux::ui
