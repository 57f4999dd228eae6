// Measures what lazily filled light costs the window: frames per second of a turning view while light is
// filled and while it is paused, in turns, and how soon the first lit picture comes.
//
//   isolux_light_rate [--rounds N] [--seconds S] [--size WxH] [--set PATH=VALUE]... PATH
//
// Needs a display; without one: xvfb-run -a -s "-screen 0 1920x1200x24" isolux_light_rate ...
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <vector>

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QThread>

#include "scene/camera.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/settings.h"
#include "tests/ui/tools/tool.h"
#include "ui/document/baked_light.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

namespace {

using namespace isolux;

using test::waitUntil;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void edit(ui::MainWindow& window, const std::function<void(scene::Scene&)>& change) {
  ui::Edit next{window.document()->scene(), "Measure", "measure", false};
  change(next.scene);
  window.document()->edit(next);
}

// Turns the view by a degree a picture, as quickly as pictures come.
double framesPerSecond(ui::MainWindow& window, double seconds) {
  int frames = 0;
  const auto connection =
      QObject::connect(window.viewport(), &ui::Viewport::drawn, [&frames](double, bool) { ++frames; });
  QElapsedTimer timer;
  timer.start();
  while (static_cast<double>(timer.elapsed()) < 1000.0 * seconds) {
    const int before = frames;
    edit(window, [&](scene::Scene& scene) {
      scene.camera = scene::orbited(window.document()->resolvedScene().camera, 0.0175, 0.0);
    });
    waitUntil([&] { return frames > before; }, 5000);
  }
  const double rate = frames / (static_cast<double>(timer.nsecsElapsed()) * 1e-9);
  QObject::disconnect(connection);
  return rate;
}

// From the switch to a picture with stored light in it.
double millisecondsToLight(ui::MainWindow& window) {
  bool drawn = false;
  QElapsedTimer timer;
  const auto connection = QObject::connect(window.viewport(), &ui::Viewport::drawn, [&](double, bool) {
    drawn = window.light()->light() && window.light()->state().counters.texelsStarted > 0;
  });
  timer.start();
  edit(window, [](scene::Scene& scene) { scene.look.mode = scene::LookMode::gi; });
  const bool came = waitUntil([&] { return drawn; });
  const double milliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
  QObject::disconnect(connection);
  return came ? milliseconds : -1.0;
}

int measure(const QCommandLineParser& options) {
  const QStringList size = options.value("size").split('x');
  ui::MainWindow window;
  window.resize(size.value(0).toInt(), size.value(1).toInt());
  window.show();
  app::WindowRequest request;
  request.scene.source.path = options.positionalArguments().value(0, "phantom:head").toStdString();
  request.host = {"picture.adaptive=false"};  // every picture has the same rays
  request.scene.picture.supersampling = 1;
  request.scene.gi.samples = 1000000;  // never complete
  test::applySettings(options, request);
  window.open(request);
  if (!waitUntil([&] { return window.document()->volume() && window.viewport()->complete(); })) {
    std::fprintf(stderr, "isolux_light_rate: no picture\n");
    return 1;
  }
  std::printf("first lit picture %.0f ms after switching on\n", millisecondsToLight(window));
  framesPerSecond(window, 1.0);  // to warm up
  std::vector<double> filling, paused;
  const double seconds = options.value("seconds").toDouble();
  for (int round = 0; round < options.value("rounds").toInt(); ++round) {
    window.light()->goOn();
    const auto before = window.light()->state().counters.rays;
    filling.push_back(framesPerSecond(window, seconds));
    waitUntil([&] { return window.light()->state().counters.rays > before; }, 1000);
    const auto rays = window.light()->state().counters.rays - before;
    window.light()->setPaused(true);
    paused.push_back(framesPerSecond(window, seconds));
    std::printf("filling %.2f pictures/s (%.3g rays meanwhile), paused %.2f pictures/s\n", filling.back(),
                static_cast<double>(rays), paused.back());
  }
  std::printf("medians: filling %.2f, paused %.2f, ratio %.3f\n", median(filling), median(paused),
              median(filling) / median(paused));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (const auto problem = ui::displayProblem()) {
      std::fprintf(stderr, "isolux_light_rate: %s\n", problem->c_str());
      return 1;
    }
    ui::prepareApplication();
    const QTemporaryDir settings;  // the user's recent files and window size are not touched
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    const QApplication application(argc, argv);
    ui::finishApplication();
    QCommandLineParser options;
    options.addOptions({{"rounds", "Rounds of both.", "N", "5"},
                        {"seconds", "Of each.", "S", "3"},
                        {"size", "Size of the window.", "WxH", "1280x800"},
                        {"set", "Override one setting.", "PATH=VALUE"}});
    options.addPositionalArgument("PATH", "What to open.");
    options.addHelpOption();
    options.process(application);
    return measure(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "isolux_light_rate: %s\n", error.what());
    return 1;
  }
}
