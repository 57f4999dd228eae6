// Makes a picture of the real window, for the README and the pages.
//
//   isolux_screenshot --out FILE.png [--size WxH] [--panel settings|marks|volume|passes|accuracy] [--find
//   TEXT]
//                     [--slices | --slices-alone] [--theme dark|light] [--preferences] [--cut-in-slice]
//                     [--hints] [--entry TEXT] [--raw-dialog] [--browser] [--anonymous]
//                     [--histogram-zoom FACTOR] [--light-at PERCENT] [--set PATH=VALUE]...
//                     [--search QUANTITY=VALUE] [--errors depth|normal|kappa|light]
//                     [--language en|de] PATH
//
// Needs a display; without one: xvfb-run -a -s "-screen 0 1920x1200x24" isolux_screenshot ...
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string_view>

#include <QAction>
#include <QApplication>
#include <QCommandLineParser>
#include <QDialog>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QThread>

#include "app/presets/preset_list.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/settings.h"
#include "tests/ui/tools/tool.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/accuracy_text.h"
#include "ui/accuracy/error_overlay_box.h"
#include "ui/accuracy/target_box.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/raw_import_dialog.h"
#include "ui/dicom_browser/dicom_browser.h"
#include "ui/dicom_browser/series_index.h"
#include "ui/document/baked_light.h"
#include "ui/document/mark_reports.h"
#include "ui/document/privacy.h"
#include "ui/editors/histogram_slider.h"
#include "ui/language/language.h"
#include "ui/panels/isovalue_panel.h"
#include "ui/panels/settings_panel.h"
#include "ui/presets/looks_panel.h"
#include "ui/presets/thumbnail_painter.h"
#include "ui/slices/slice_board.h"
#include "ui/theme/style.h"
#include "ui/theme/theme.h"
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
    if (timer.elapsed() > 600000) return false;
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

// Triggers the entry of a menu that begins so, keys of the menu left out.
bool trigger(const ui::MainWindow& window, const QString& entry) {
  for (QAction* menu : window.menuBar()->actions())
    for (QAction* action : menu->menu()->actions())
      if (QString(action->text()).remove('&').startsWith(entry)) {
        action->trigger();
        return true;
      }
  return false;
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

  if (options.isSet("anonymous")) ui::keepPrivacy({.hideOnScreen = true, .hideInSaved = true});
  if (options.isSet("browser")) {
    ui::SeriesIndex index;
    ui::DicomBrowser dialog(&index, nullptr);
    dialog.resize(size[0].toInt(), size[1].toInt());
    dialog.show();
    index.start(path);
    if (!waitUntil([&] { return !index.running() && dialog.picturesComplete(); })) return fail("no list");
    return save(dialog.grab(), out);
  }

  ui::MainWindow window;
  window.resize(size[0].toInt(), size[1].toInt());
  window.show();
  app::WindowRequest request;
  request.scene.source.path = path.toStdString();
  test::applySettings(options, request);
  window.open(request);
  const auto failed = [&] {
    return window.messageBar()->isVisible() && window.messageBar()->kind() == ui::MessageBar::Kind::error;
  };
  waitUntil([&] { return failed() || window.document()->volume() != nullptr; });
  if (failed()) return fail(window.messageBar()->text());
  if (!options.isSet("notes")) window.messageBar()->clear();
  if (options.isSet("preset"))
    window.document()->edit(
        {app::withPreset(window.document()->scene(), app::findPreset(options.value("preset").toStdString()),
                         *window.document()->volume()),
         "",
         {},
         false});
  window.showPanel(options.value("panel"));
  window.panel<ui::SettingsPanel>()->searchLine()->setText(options.value("find"));
  const double zoom = options.value("histogram-zoom").toDouble();
  if (zoom > 1.0) window.panel<ui::HistogramSlider>()->zoomAtLine(zoom);
  window.slices()->arrange(options.isSet("slices")         ? ui::ViewLayout::fourUp
                           : options.isSet("slices-alone") ? ui::ViewLayout::slices
                                                           : ui::ViewLayout::picture);
  if (options.isSet("cut-in-slice"))
    window.slices()->view(volume::SliceDirection::sagittal)->choose({.kind = app::SliceChoice::Kind::cut});
  const auto sliced = [&] {
    using volume::SliceDirection;
    for (const auto direction : {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal})
      if (window.slices()->slicesShown() && !window.slices()->view(direction)->complete()) return false;
    return true;
  };
  const auto pictured = [&] {
    const auto* const looks = window.panel<ui::LooksPanel>();
    return !looks->isVisible() || (looks->painter().drawnCount() > 0 && looks->painter().complete());
  };
  const auto measured = [&] {
    const auto* const accuracy = window.panel<ui::AccuracyPanel>();
    if (!accuracy->isVisible() || accuracy->visibleRegion().isEmpty() || options.isSet("search")) return true;
    return accuracy->picture().known() && (accuracy->complete() || options.isSet("errors"));
  };
  const auto drawn = [&] {
    return measured() && !window.light()->changing() &&
           (window.viewport()->complete() || !window.viewport()->isVisible()) &&
           !window.marks()->measuring() && sliced() && pictured();
  };
  const QString at = options.value("light-at");  // per cent
  if (!at.isEmpty()) {
    const auto there = [&] {
      const gi::BakeCounters& counters = window.light()->state().counters;
      return counters.samplesWanted > 0 && 100.0 * static_cast<double>(counters.samplesDone) >=
                                               at.toDouble() * static_cast<double>(counters.samplesWanted);
    };
    if (!waitUntil(there)) return fail("no light in ten minutes");
  } else if (!waitUntil(drawn))
    return fail("no full picture in ten minutes");
  QElapsedTimer settle;
  settle.start();
  waitUntil([&] { return settle.elapsed() > 400; });
  if (options.isSet("preferences")) {
    ui::PreferencesDialog dialog(window.host(), &window);
    dialog.show();
    waitUntil([&] { return dialog.isVisible(); });
    return save(dialog.grab(), out);
  }
  if (options.isSet("search")) {
    ui::TargetBox* const target = window.panel<ui::AccuracyPanel>()->findChild<ui::TargetBox*>();
    const app::Limit limit = app::parseErrorTarget(options.value("search").toStdString()).front();
    target->askError(limit.quantity, limit.most / ui::unitOf(limit.quantity));
    target->findButton()->click();
    if (!waitUntil([&] { return !target->searching(); })) return fail("no settings in ten minutes");
  }
  if (options.isSet("errors")) {
    ui::ErrorOverlayBox* const overlay = window.panel<ui::AccuracyPanel>()->overlay();
    const app::OverlayRequest asked = app::parseOverlay(options.value("errors").toStdString(), {});
    overlay->choose(asked.colors);
    if (!waitUntil([&] {
          return !overlay->note().isEmpty() ||
                 (window.viewport()->showsOver(ui::Viewport::Over::errors) && !overlay->working());
        }))
      return fail("no errors in ten minutes");
  }
  if (options.isSet("hints")) window.greet();
  if (options.isSet("entry") && !trigger(window, options.value("entry"))) return fail("no such entry");
  settle.start();
  waitUntil([&] { return settle.elapsed() > 400; });
  QWidget* shown = &window;
  for (QWidget* top : QApplication::topLevelWidgets())
    if (top->isVisible() && qobject_cast<QDialog*>(top) != nullptr) shown = top;
  return save(shown->grab(), out);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (const auto problem = ui::displayProblem()) return fail(QString::fromStdString(*problem));
    ui::prepareApplication();
    const QTemporaryDir settings;  // the user's recent files and window size are not touched
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    for (int i = 1; i + 1 < argc; ++i)
      if (std::string_view(argv[i]) == "--scale") ui::applyInterfaceScale(std::atoi(argv[i + 1]));
    const QApplication application(argc, argv);
    ui::finishApplication();
    QCommandLineParser options;
    options.addOptions(
        {{"out", "The picture to write.", "FILE"},
         {"size", "Size of the window.", "WxH", "1280x800"},
         {"panel", "settings, looks, marks, volume, pieces, passes or accuracy.", "NAME", "settings"},
         {"preset", "Show this preset.", "NAME"},
         {"notes", "Leave the message that opening ends with."},
         {"find", "Search the settings for this.", "TEXT"},
         {"search", "In the Accuracy panel, the settings that keep this error.", "QUANTITY=VALUE"},
         {"errors", "In the Accuracy panel, the errors shown in the picture.", "ERROR"},
         {"histogram-zoom", "Zoom the histogram about the isovalue.", "FACTOR", "1"},
         {"light-at", "As it is at so much of the stored light.", "PERCENT"},
         {"slices", "With slices beside the picture."},
         {"slices-alone", "Slices without the picture."},
         {"cut-in-slice", "The sagittal slice shows the first cut."},
         {"theme", "Colours of the window: dark or light.", "NAME", "dark"},
         {"scale", "Size of texts and controls, per cent.", "PERCENT", "100"},
         {"preferences", "The preferences instead of the window."},
         {"hints", "With the hints of the first start."},
         {"entry", "After this entry of a menu; a dialog that it opens instead of the window.", "TEXT"},
         {"raw-dialog", "The dialog for files without a header instead of the window."},
         {"browser", "The DICOM browser on a folder instead of the window."},
         {"anonymous", "With patients' names hidden."},
         {"language", "en or de.", "NAME", "en"},
         {"set", "Override one setting.", "PATH=VALUE"}});
    options.addPositionalArgument("PATH", "What to open.");
    options.addHelpOption();
    options.process(application);
    ui::applyTheme(options.value("theme") == "light" ? ui::Theme::light : ui::Theme::dark);
    if (!options.isSet("out")) return fail("--out FILE is missing");
    ui::setLanguage(ui::spokenOf({options.value("language")}));
    return takePicture(options);
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}
