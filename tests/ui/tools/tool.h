// Provides what the tools that drive the window share.
#pragma once

#include <functional>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>

#include "app/commands/command_line.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/settings.h"

namespace isolux::test {

// Processes events until the condition holds. Returns false at the time limit.
inline bool waitUntil(const std::function<bool()>& condition, int milliseconds = 120000) {
  QElapsedTimer timer;
  timer.start();
  while (!condition()) {
    if (timer.elapsed() > milliseconds) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
  }
  return true;
}

// Applies the options --set, of the scene and of the machine. Throws base::Error.
inline void applySettings(const QCommandLineParser& options, app::WindowRequest& request) {
  for (const QString& assignment : options.values("set"))
    if (const std::string text = assignment.toStdString(); scene::isHostSetting(text))
      request.host.push_back(text);
    else
      scene::applyAssignment(request.scene, text);
}

}  // namespace isolux::test
