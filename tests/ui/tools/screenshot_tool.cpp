// Makes a picture of the real window, for the README and the pages.
//
//   isolux_screenshot --out FILE.png [--size WxH] [--panel settings|marks|volume|passes] [--find TEXT]
//                     [--slices] [--raw-dialog] [--histogram-zoom FACTOR] [--light-at PERCENT] [--set
//                     PATH=VALUE]... [--language en|de] [--preferences] PATH
//
// Needs a display; without one: xvfb-run -a -s "-screen 0 1920x1200x24" isolux_screenshot ...
#include <cstdio>
#include <exception>
#include <functional>

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QThread>

#include "scene/machine.h"
#include "scene/settings.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/raw_import_dialog.h"
#include "ui/document/baked_light.h"
#include "ui/document/mark_reports.h"
#include "ui/editors/histogram_slider.h"
#include "ui/language/language.h"
#include "ui/panels/isovalue_panel.h"
#include "ui/panels/settings_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace {

using namespace isolux;

int fail(const QString& reason) {
  std::fprintf(stderr, "isolux_screenshot: %s\n", reason.toUtf8().constData());
  return 1;
}

bool waitUntil(const std::function<bool()>& condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition()) {
    if (timer.elapsed() > 120000) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    QThread::msleep(1);
  }
  return true;
}

int save(const QPixmap& picture, const QString& file) {
  if (!picture.save(file)) return fail(file + " cannot be written");
  std::printf("%s\n", file.toUtf8().constData());
  return 0;
}

int takePicture(const QCommandLineParser& options) {
  const QStringList size = options.value("size").split('x');
  if (size.size() != 2 || size[0].toInt() < 1 || size[1].toInt() < 1) return fail("--size is not WxH");
  const QString out = options.value("out"), path = options.positionalArguments().value(0, "phantom:head");
  if (options.isSet("raw-dialog")) {
    ui::RawImportDialog dialog(path);
    dialog.show();
    if (!waitUntil([&] { return !dialog.previewImage().isNull(); })) return fail("no slice to show");
    return save(dialog.grab(), out);
  }
  if (options.isSet("preferences")) {
    ui::PreferencesDialog dialog({}, nullptr);
    return save(dialog.grab(), out);
  }

  ui::MainWindow window;
  window.resize(size[0].toInt(), size[1].toInt());
  window.show();
  app::WindowRequest request;
  request.scene.source.path = path.toStdString();
  for (const QString& assignment : options.values("set"))
    if (const std::string text = assignment.toStdString(); scene::isOfMachine(text))
      request.machine.push_back(text);
    else
      scene::applyAssignment(request.scene, text);
  window.open(request);
  const auto failed = [&] {
    return window.messageBar()->isVisible() && window.messageBar()->kind() == ui::MessageBar::Kind::error;
  };
  waitUntil([&] { return failed() || window.document()->volume() != nullptr; });
  if (failed()) return fail(window.messageBar()->text());
  window.messageBar()->clear();
  window.showPanel(options.value("panel"));
  window.panel<ui::SettingsPanel>()->searchLine()->setText(options.value("find"));
  const double zoom = options.value("histogram-zoom").toDouble();
  if (zoom > 1.0) window.isovaluePanel()->slider()->zoomAtLine(zoom);
  window.slices()->setFourUp(options.isSet("slices"));
  const auto sliced = [&] {
    using volume::SliceDirection;
    for (const auto direction : {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal})
      if (window.slices()->fourUp() && !window.slices()->view(direction)->complete()) return false;
    return true;
  };
  const auto drawn = [&] {
    return !window.light()->changing() && window.viewport()->complete() && !window.marks()->measuring() &&
           sliced();
  };
  const QString at = options.value("light-at");  // per cent
  if (!at.isEmpty()) {
    const auto there = [&] {
      const gi::BakeCounters& counters = window.light()->state().counters;
      return counters.samplesWanted > 0 && 100.0 * static_cast<double>(counters.samplesDone) >=
                                               at.toDouble() * static_cast<double>(counters.samplesWanted);
    };
    if (!waitUntil(there)) return fail("no light in two minutes");
  } else if (!waitUntil(drawn))
    return fail("no full picture in two minutes");
  QElapsedTimer settle;
  settle.start();
  waitUntil([&] { return settle.elapsed() > 400; });
  return save(window.grab(), out);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (const auto problem = ui::displayProblem()) return fail(QString::fromStdString(*problem));
    ui::prepareApplication();
    const QTemporaryDir settings;  // the user's recent files and window size are not touched
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    const QApplication application(argc, argv);
    ui::finishApplication();
    QCommandLineParser options;
    options.addOptions({{"out", "The picture to write.", "FILE"},
                        {"size", "Size of the window.", "WxH", "1280x800"},
                        {"panel", "settings, marks, volume or passes.", "NAME", "settings"},
                        {"find", "Search the settings for this.", "TEXT"},
                        {"histogram-zoom", "Zoom the histogram about the isovalue.", "FACTOR", "1"},
                        {"light-at", "As it is at so much of the stored light.", "PERCENT"},
                        {"slices", "With slices beside the picture."},
                        {"raw-dialog", "The dialog for files without a header instead of the window."},
                        {"language", "en or de.", "NAME", "en"},
                        {"preferences", "The dialog of preferences instead of the window."},
                        {"set", "Override one setting.", "PATH=VALUE"}});
    options.addPositionalArgument("PATH", "What to open.");
    options.addHelpOption();
    options.process(application);
    if (!options.isSet("out")) return fail("--out FILE is missing");
    ui::setLanguage(ui::spokenOf({options.value("language")}));
    return takePicture(options);
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}
