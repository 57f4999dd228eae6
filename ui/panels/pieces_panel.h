// The connected pieces of the first isosurface: a list with volumes, to hide, isolate and find them.
//
// They are found and measured on a background thread, and only while the panel is seen: first the list with
// estimates, then volumes with their errors and boxes. A check mark is whether a piece is shown.
#pragma once

#include <QLabel>
#include <QTimer>

#include "app/tasks/piece_task.h"
#include "ui/document/background_task.h"
#include "ui/panels/panel.h"

class QLayout;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace isolux::ui {

class SettingEditor;

class PiecesPanel : public Panel {
  Q_OBJECT
 public:
  explicit PiecesPanel(QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume) override;
  void setScene(const scene::Scene& scene, const scene::Scene& resolved) override;
  QTreeWidget* list() const { return list_; }
  QString state() const { return heading_->text(); }  // what stands above the list
  bool measured() const;  // the list is of the scene on show, with errors and boxes
  bool working() const { return bool(task_); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void themeChanged() override { showFound(); }

 private:
  void makeList();
  QLayout* makeButtons();
  QPushButton* addButton(const QString& text, const QString& tip, void (PiecesPanel::*clicked)());
  bool current() const;  // found_ is of the scene's isosurface
  void findSoon();
  bool isWanted() const;  // the isosurface is seen, neither measured nor being so
  void find();
  void take(app::PieceTask& task);
  void showFound();
  void showRows();
  void fillRows(const std::vector<bool>& shown, std::size_t rows);
  void fillRow(QTreeWidgetItem* item, std::size_t id, bool shown) const;
  void showState();
  void enableButtons();
  std::vector<std::size_t> selected() const;  // ids
  std::vector<glm::dvec3> selectedSeeds() const;
  QString nameOfSelected(const QString& one, const QString& several) const;
  void choose(const QString& name, const scene::Pieces& choice);
  void toggle(QTreeWidgetItem* item, int column);
  void hideSelected();
  void isolateSelected();
  void centreSelected();
  void showAll();

  VolumePointer volume_, foundOf_;
  scene::Scene scene_, resolved_;
  app::FoundPieces found_;
  BackgroundTask<app::FoundPieces> task_;
  app::PieceSubject asked_;  // of the task
  QTimer restTimer_;

  QLabel *heading_, *more_;
  QTreeWidget* list_;
  QPushButton *hide_, *only_, *centre_, *all_;  // of controls_
  QWidget* controls_;
  std::vector<SettingEditor*> editors_;
};

}  // namespace isolux::ui
