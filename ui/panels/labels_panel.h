// The labels of a label map: a list with colours, names and volumes, to search, show, hide and isolate them.
//
// A check mark is whether a label is shown. The volume of a label is that of its voxels. Labels may have
// surfaces of their own, which are listed below.
#pragma once

#include <vector>

#include "ui/panels/panel.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QTreeWidget;
class QTreeWidgetItem;

namespace isolux::ui {

class SettingEditor;
class SurfaceList;

class LabelsPanel : public Panel {
  Q_OBJECT
 public:
  explicit LabelsPanel(QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume) override;
  void setScene(const scene::Scene& scene, const scene::Scene& resolved) override;
  QTreeWidget* list() const { return list_; }
  QLineEdit* searchLine() const { return search_; }
  SettingEditor* smoothing() const { return smoothing_; }
  SurfaceList* surfaces() const { return surfaces_; }

 protected:
  void themeChanged() override { fill(); }

 private:
  QPushButton* addButton(const QString& text, const QString& tip);
  void fill();
  void showChecks();
  void search(const QString& text);
  void toggle(QTreeWidgetItem* item);
  void makeOwnSurface();
  // Sends those labels as the shown ones.
  void show(const std::vector<int>& labels, const QString& name);
  std::vector<int> where(bool (*wanted)(const QTreeWidgetItem& item)) const;

  VolumePointer volume_;
  scene::Scene scene_, resolved_;
  QLabel* heading_;
  QLineEdit* search_;
  QTreeWidget* list_;
  QWidget* controls_;
  QPushButton *hide_, *only_, *all_, *apart_;
  SurfaceList* surfaces_;
  QScrollArea* surfaceScroll_;
  SettingEditor* smoothing_;
  bool filling_ = false;
};

}  // namespace isolux::ui
