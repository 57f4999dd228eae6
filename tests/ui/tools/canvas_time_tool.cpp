// Measures, for both canvases in turns, how long a finished picture takes to the screen, and how soon moves
// of the mouse are answered.
//
//   isolux_canvas_time [--rounds N] [--moves N] [--size WxH] [--set PATH=VALUE]... PATH
//
// `size` is that of the picture, in pixels of the screen. Needs a display; without one:
// xvfb-run -a -s "-screen 0 3840x2400x24" isolux_canvas_time ...
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <vector>

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QThread>

#include "scene/settings/host_settings.h"
#include "scene/settings/settings.h"
#include "tests/ui/tools/tool.h"
#include "ui/document/preferences.h"
#include "ui/viewport/canvas_choice.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

namespace {

using namespace isolux;

using test::waitUntil;

// Tells when the window system has been given what a turn of painting has made.
class Application : public QApplication {
 public:
  using QApplication::QApplication;
  std::function<void()> updated;
  bool notify(QObject* receiver, QEvent* event) override {
    const bool isUpdate = event->type() == QEvent::UpdateRequest;
    const bool done = QApplication::notify(receiver, event);
    if (isUpdate && updated) updated();
    return done;
  }
};

struct Times {
  std::vector<double> answers, toScreen;  // ms
  double processorMs = 0.0;               // of the window's thread
};

double threadMilliseconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

void sendMouse(QWidget* widget, QEvent::Type type, QPointF position, Qt::MouseButton button) {
  QMouseEvent event(type, position, widget->mapToGlobal(position), button, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(widget, &event);
}

// A drag of so many moves, a display's frame apart.
void dragAbout(Application& application, ui::Viewport* viewport, int moves, Times& times) {
  QElapsedTimer sincePainted;
  std::vector<double> painted;
  const auto connection =
      QObject::connect(viewport, &ui::Viewport::answered, [&](double milliseconds, double sinceFinished) {
        times.answers.push_back(milliseconds);
        painted.push_back(sinceFinished);
        sincePainted.start();
      });
  application.updated = [&] {
    for (const double until : painted)
      times.toScreen.push_back(until + static_cast<double>(sincePainted.nsecsElapsed()) * 1e-6);
    painted.clear();
  };
  const double before = threadMilliseconds();
  const QPointF middle(viewport->rect().center());
  sendMouse(viewport, QEvent::MouseButtonPress, middle, Qt::LeftButton);
  for (int move = 0; move < moves; ++move) {
    sendMouse(viewport, QEvent::MouseMove, middle + QPointF(move % 200 - 100, (move * 7) % 80 - 40),
              Qt::NoButton);
    QElapsedTimer frame;
    frame.start();
    while (frame.nsecsElapsed() < 16'700'000) {
      QCoreApplication::processEvents(QEventLoop::AllEvents, 2);
      QThread::usleep(200);  // another thread draws
    }
  }
  QMouseEvent release(QEvent::MouseButtonRelease, middle, viewport->mapToGlobal(middle), Qt::LeftButton,
                      Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(viewport, &release);
  application.updated = {};
  times.processorMs += threadMilliseconds() - before;
  QObject::disconnect(connection);
}

void print(const char* what, std::vector<double> times) {
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  const auto at = [&](double part) {
    return times[std::min(times.size() - 1,
                          static_cast<std::size_t>(part * static_cast<double>(times.size())))];
  };
  std::printf("  %s: median %.1f ms, 99 %% %.1f ms, longest %.1f ms (%zu)\n", what, at(0.5), at(0.99),
              times.back(), times.size());
}

// In a window of its own: one that has once shown textures goes on being composed by OpenGL.
bool measure(Application& application, const QCommandLineParser& options, scene::Canvas canvas,
             Times& times) {
  const QStringList size = options.value("size").split('x');
  const QSize wanted(size.value(0).toInt(), size.value(1).toInt());
  ui::saveHostSettings(ui::savedHostSettings(), {.canvas = canvas});
  ui::MainWindow window;
  window.show();
  app::WindowRequest request;
  request.scene.source.path = options.positionalArguments().value(0, "phantom:head").toStdString();
  test::applySettings(options, request);
  window.open(request);
  ui::Viewport* const viewport = window.viewport();
  window.resize(window.size() + wanted - viewport->size());
  const auto complete = [&] { return window.document()->volume() && viewport->complete(); };
  if (!waitUntil(complete)) return false;
  Times warmUp;
  dragAbout(application, viewport, 40, warmUp);
  dragAbout(application, viewport, options.value("moves").toInt(), times);
  return waitUntil(complete);
}

int measure(Application& application, const QCommandLineParser& options) {
  std::map<scene::Canvas, Times> times;
  for (int round = 0; round < options.value("rounds").toInt(); ++round)
    for (const auto canvas : {scene::Canvas::textures, scene::Canvas::pixels})
      if (!measure(application, options, canvas, times[canvas])) {
        std::fprintf(stderr, "isolux_canvas_time: no picture\n");
        return 1;
      }
  std::printf("%s\n", qPrintable(options.value("size")));
  for (const auto& [canvas, of] : times) {
    std::printf("%s\n", canvas == scene::Canvas::textures ? "textures" : "pixels");
    print("finished to screen", of.toScreen);
    print("move to picture", of.answers);
    std::printf("  processor of the window's thread: %.1f ms a picture\n",
                of.processorMs / static_cast<double>(std::max<std::size_t>(of.answers.size(), 1)));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (const auto problem = ui::displayProblem()) {
      std::fprintf(stderr, "isolux_canvas_time: %s\n", problem->c_str());
      return 1;
    }
    ui::prepareApplication();
    const QTemporaryDir settings;  // the user's recent files and window size are not touched
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    ui::prepareCanvas(scene::Canvas::textures);
    Application application(argc, argv);
    ui::finishApplication();
    QCommandLineParser options;
    options.addOptions({{"rounds", "Rounds of both canvases.", "N", "3"},
                        {"moves", "Moves of the mouse in each.", "N", "200"},
                        {"size", "Size of the picture.", "WxH", "1280x900"},
                        {"set", "Override one setting.", "PATH=VALUE"}});
    options.addPositionalArgument("PATH", "What to open.");
    options.addHelpOption();
    options.process(application);
    return measure(application, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "isolux_canvas_time: %s\n", error.what());
    return 1;
  }
}
