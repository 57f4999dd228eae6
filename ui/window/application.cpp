#include "ui/window/application.h"

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <dlfcn.h>
#include <malloc.h>

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>

#include "app/files/state_folder.h"
#include "app/version.h"
#include "base/caught_error.h"
#include "base/destroy_in_background.h"
#include "ui/document/preferences.h"
#include "ui/language/language.h"
#include "ui/theme/focus_ring.h"
#include "ui/theme/icons.h"
#include "ui/theme/style.h"
#include "ui/theme/theme.h"
#include "ui/viewport/canvas_choice.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace isolux::ui {

namespace {
constexpr double secondsToEnd = 1.0;

bool isSet(const char* name) {
  return !qEnvironmentVariableIsEmpty(name);
}

// Whether an X server answers, asked through libxcb without linking to it. True when that cannot be asked.
bool xServerAnswers() {
  void* library = dlopen("libxcb.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return true;
  using Connect = void* (*)(const char*, int*);
  using HasError = int (*)(void*);
  using Disconnect = void (*)(void*);
  const auto connect = reinterpret_cast<Connect>(dlsym(library, "xcb_connect"));
  const auto hasError = reinterpret_cast<HasError>(dlsym(library, "xcb_connection_has_error"));
  const auto disconnect = reinterpret_cast<Disconnect>(dlsym(library, "xcb_disconnect"));
  bool answers = true;
  if (connect != nullptr && hasError != nullptr && disconnect != nullptr) {
    void* connection = connect(nullptr, nullptr);
    answers = hasError(connection) == 0;
    disconnect(connection);
  }
  dlclose(library);
  return answers;
}

bool waylandPluginInstalled() {
  const QDir folder(QLibraryInfo::path(QLibraryInfo::PluginsPath) + "/platforms");
  return !folder.entryList({"libqwayland*"}, QDir::Files).isEmpty();
}
}  // namespace

bool Application::notify(QObject* receiver, QEvent* event) {
  bool done = false;
  const auto error = base::caughtError("", "do this", [&] { done = QApplication::notify(receiver, event); });
  if (!error) return done;
  for (QWidget* const widget : topLevelWidgets())
    if (auto* const window = qobject_cast<MainWindow*>(widget))
      window->messageBar()->show(MessageBar::Kind::error, QString::fromStdString(error->what()));
  return false;
}

std::optional<std::string> displayProblem() {
  if (isSet("QT_QPA_PLATFORM")) return std::nullopt;  // the user knows better
  if (isSet("WAYLAND_DISPLAY") && waylandPluginInstalled()) return std::nullopt;
  if (const char* const display = std::getenv("DISPLAY"); display && *display) {
    if (xServerAnswers()) return std::nullopt;
    return "the X server at DISPLAY=" + std::string(display) + " does not answer";
  }
  if (isSet("WAYLAND_DISPLAY")) return "Qt's Wayland plugin is not installed (package qt6-wayland)";
  return "there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)";
}

void prepareApplication() {
#ifdef __GLIBC__
  // A heap for all threads: what volumes leave in a heap of each thread grows with every one that is opened.
  mallopt(M_ARENA_MAX, 1);
#endif
  QCoreApplication::setOrganizationName("Isolux");
  QCoreApplication::setApplicationName("isolux");
  QGuiApplication::setDesktopFileName("isolux");  // by which a desktop knows whose window it is
  QCoreApplication::setApplicationVersion(QString::fromUtf8(app::version()));
}

void finishApplication() {
  // QApplication takes the user's locale; files and settings are written with a point in every country.
  std::setlocale(LC_NUMERIC, "C");
  QLocale::setDefault(QLocale::c());
  applyTheme(savedTheme());
  FocusRing::install();
  QApplication::setWindowIcon(applicationIcon());
  QGuiApplication::setApplicationDisplayName("Isolux");
}

std::string describeWindow() {
  if (const auto problem = displayProblem()) return "none: " + *problem;
  prepareApplication();
  const scene::Canvas asked = savedHostSettings().canvas;
  prepareCanvas(asked);
  int argc = 1;
  char name[] = "isolux";
  char* argv[] = {name, nullptr};
  const QApplication application(argc, argv);
  return describe(chooseCanvas(asked)).toStdString();
}

namespace {

scene::Canvas requestedCanvas(const app::WindowRequest& request) {
  scene::HostSettings host = savedHostSettings();
  for (const std::string& assignment : request.host) scene::applyAssignment(host, assignment);
  return host.canvas;
}

}  // namespace

int openWindow(const app::WindowRequest& request) {
  if (const auto problem = displayProblem()) {
    throw base::Error(base::ErrorKind::graphics, "", "no window",
                      *problem + "; `isolux render` makes pictures without one");
  }
  prepareApplication();
  constexpr auto scaleVariable = "QT_SCALE_FACTOR";
  const bool scaleIsGiven = qEnvironmentVariableIsSet(scaleVariable);
  applyInterfaceScale(savedScale());
  prepareCanvas(requestedCanvas(request));
  int argc = 1;
  char name[] = "isolux";
  char* argv[] = {name, nullptr};
  const Application application(argc, argv);
  if (!scaleIsGiven) qunsetenv(scaleVariable);  // it is no scale of the programs that are started from here
  finishApplication();

  setLanguage(savedLanguage());
  auto made = std::make_unique<MainWindow>();
  MainWindow& window = *made;
  constexpr int turnMilliseconds = 150;  // views that are asked for by name
  window.viewport()->setTurnMilliseconds(turnMilliseconds);
  QObject::connect(&application, &QGuiApplication::commitDataRequest, &window, &MainWindow::commitData,
                   Qt::DirectConnection);
  window.show();
  window.open(request);
  window.greet();
  if (const auto folder = app::stateFolder(); !folder.empty()) window.keepDocument(folder / "autosave");
  const int exitCode = QApplication::exec();
  made.reset();
  // Threads that draw have contexts of the window system, which goes with the application.
  if (!base::awaitDestroyed(secondsToEnd)) {
    std::fflush(nullptr);
    std::_Exit(exitCode);
  }
  return exitCode;
}

}  // namespace isolux::ui
