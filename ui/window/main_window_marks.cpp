// The Measure menu of ui/window/main_window.h, and files of marks.
#include <QActionGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/documents/anonymous.h"
#include "app/files/files.h"
#include "app/marks/mark_kinds.h"
#include "app/marks/markups_file.h"
#include "ui/document/mark_reports.h"
#include "ui/document/privacy.h"
#include "ui/document/recent_files.h"
#include "ui/panels/marks_panel.h"
#include "ui/theme/icons.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace isolux::ui {

namespace {

constexpr auto markupsFilter = QT_TRANSLATE_NOOP("QObject", "3D Slicer markups (*.mrk.json)");
constexpr auto tableFilter = QT_TRANSLATE_NOOP("QObject", "Table of measured values (*.csv)");

struct MarkTool {
  scene::MarkKind kind;
  const char *text, *keys, *tip;
};
constexpr MarkTool markTools[] = {
    {scene::MarkKind::point, QT_TRANSLATE_NOOP("QObject", "&Pin"), "P",
     QT_TRANSLATE_NOOP("QObject", "Mark a point on the surface: position, value, curvature, edge")},
    {scene::MarkKind::distance, QT_TRANSLATE_NOOP("QObject", "&Distance"), "M",
     QT_TRANSLATE_NOOP("QObject", "Measure straight from point to point")},
    {scene::MarkKind::path, QT_TRANSLATE_NOOP("QObject", "Geode&sic distance"), "Shift+M",
     QT_TRANSLATE_NOOP("QObject", "Measure the shortest path found along the surface")},
    {scene::MarkKind::angle, QT_TRANSLATE_NOOP("QObject", "&Angle"), "",
     QT_TRANSLATE_NOOP("QObject", "Measure at the second of three points, or between two lines")},
    {scene::MarkKind::circle, QT_TRANSLATE_NOOP("QObject", "&Circle"), "",
     QT_TRANSLATE_NOOP("QObject", "Measure radius and centre of a circle through three points")},
    {scene::MarkKind::thickness, QT_TRANSLATE_NOOP("QObject", "&Thickness"), "",
     QT_TRANSLATE_NOOP("QObject", "Measure from the surface through the inside")},
    {scene::MarkKind::piece, QT_TRANSLATE_NOOP("QObject", "Pi&ece"), "",
     QT_TRANSLATE_NOOP("QObject", "Measure volume and area of a piece (connected component)")},
};

}  // namespace

void MainWindow::makeMeasureMenu() {
  QMenu* menu = measureMenu_ = menuBar()->addMenu(tr("&Measure"));
  menu->setToolTipsVisible(true);
  markTools_ = new QActionGroup(this);
  markTools_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  for (const MarkTool& tool : markTools) {
    const auto choose = [this, kind = tool.kind](bool on) {
      viewport_->setTool(on ? std::optional(kind) : std::nullopt);
      if (on) viewport_->setFocus();
    };
    QAction* action = needsVolume(newAction(menu, QObject::tr(tool.text), "", QKeySequence(tool.keys),
                                            QObject::tr(tool.tip), this, choose));
    action->setCheckable(true);
    action->setData(static_cast<int>(tool.kind));
    markTools_->addAction(action);
  }
  menu->addSeparator();
  newAction(menu, tr("&List of measurements"), "", {}, tr("Show the Measure panel"), this,
            [this] { showPanel("Marks"); });
  exportMarks_ = newAction(menu, tr("E&xport measurements…"), "", {},
                           tr("Save as a table (CSV) or for 3D Slicer (.mrk.json)"), this,
                           &MainWindow::chooseMarksToExport);
  needsVolume(newAction(menu, tr("&Import measurements…"), "", {}, tr("Open 3D Slicer markups (.mrk.json)"),
                        this, &MainWindow::chooseMarksToImport));
}

void MainWindow::connectMarks() {
  auto* const panel = this->panel<MarksPanel>();
  connect(marks_, &MarkReports::changed, this, [this, panel] {
    viewport_->setMarks(marks_->marks(), marks_->reports());
    panel->setReports(marks_->reports(), marks_->measuring());
  });
  connect(panel, &MarksPanel::exportWanted, this, &MainWindow::chooseMarksToExport);
  connect(panel, &MarksPanel::importWanted, this, &MainWindow::chooseMarksToImport);
  connect(panel, &MarksPanel::stopWanted, marks_, &MarkReports::stop);
  connect(panel, &MarksPanel::anywayWanted, marks_, &MarkReports::measureAnyway);
  connect(viewport_, &Viewport::toolChanged, this, [this] {
    for (QAction* action : markTools_->actions())
      action->setChecked(viewport_->tool() && action->data().toInt() == static_cast<int>(*viewport_->tool()));
  });
}

bool MainWindow::exportMarks(const QString& file) {
  return attempt([&] {
    const std::filesystem::path path = file.toStdString();
    const bool table = QFileInfo(file).suffix().compare("csv", Qt::CaseInsensitive) == 0;
    if (!table && !file.endsWith(".json", Qt::CaseInsensitive))
      base::throwInput(path.filename().string(), "",
                       tr("unknown format for measurements; use .csv or .mrk.json").toStdString());
    document_->checkOutput(file);
    scene::Scene named;
    named.marks = marks_->marks();
    const std::vector<scene::Mark> marks =
        app::withoutPatient(named, hiddenInSaved(document_->volume())).marks;
    app::writeTextFile(path, table ? app::marksCsv(marks, marks_->reports()) : app::markupsText(marks));
    tellSaved(file, table && marks_->measuring() ? tr("some measurements were not finished") : "");
  });
}

bool MainWindow::importMarks(const QString& file) {
  return attempt([&] {
    const app::ReadMarks read = app::readMarkups(file.toStdString());
    const auto count = read.marks.size();
    const QString name = QFileInfo(file).fileName();
    QString text = count == 1 ? tr("1 measurement from %1").arg(name)
                              : tr("%1 measurements from %2").arg(count).arg(name);
    if (!read.notes.empty()) text += "; " + tr("skipped: %1").arg(QString::fromStdString(read.notes.front()));
    if (count > 0) {
      Edit edit{document_->scene(), tr("Import measurements")};
      edit.scene.marks.insert(edit.scene.marks.end(), read.marks.begin(), read.marks.end());
      document_->edit(edit);
      showPanel("Marks");
    }
    message_->showNote(text);
  });
}

void MainWindow::chooseMarksToExport() {
  const QString file = askForFileToSave(this, tr("Export measurements"), proposedFile(".mrk.json"),
                                        {QObject::tr(markupsFilter), QObject::tr(tableFilter)});
  if (!file.isEmpty()) exportMarks(file);
}

void MainWindow::chooseMarksToImport() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Import measurements"), lastFolder(),
                                   tr("3D Slicer markups (*.mrk.json *.json);;All files (*)"));
  if (!path.isEmpty()) importMarks(path);
}

}  // namespace isolux::ui
