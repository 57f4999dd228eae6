// The surfaces as a compact list: a row for each with a handle to move it by, whether it is shown, colour,
// name, its value or labels, opacity, whether it is seen through where it faces the viewer, and a button that
// removes it. A long list can be searched by name.
#pragma once

#include <vector>

#include <QWidget>

#include "app/surface_list/surface_list.h"
#include "ui/document/document.h"
#include "ui/document/edit.h"

class QCheckBox;
class QFrame;
class QGridLayout;
class QLabel;
class QLineEdit;
class QSlider;
class QToolButton;

namespace isolux::ui {

class ColorButton;
class NumberSpinBox;

class SurfaceList : public QWidget {
  Q_OBJECT
 public:
  explicit SurfaceList(QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  void setStep(double step);  // of the values' arrows

  struct Row {
    int number;
    QLabel* handle;  // dragged, or moved by the arrow keys
    QCheckBox* shown;
    ColorButton* colour;
    QLineEdit* name;
    NumberSpinBox* value;  // of an isosurface
    QLineEdit* labels;     // of a surface of labels
    QSlider* opacity;
    QToolButton *seeThrough, *remove;
  };
  const std::vector<Row>& rows() const { return rows_; }
  QLineEdit* searchLine() const { return search_; }

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void dragStarted();
  void dragEnded();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;  // of handles

 private:
  void search();
  int rowAt(int y) const;  // the nearest
  void move(int from, int to);
  void makeRows(const std::vector<app::ListedSurface>& list);
  Row makeRow(int number);
  void connectRow(const Row& row);
  static std::vector<QWidget*> widgetsOf(const Row& row);
  static void fill(const Row& row, const app::ListedSurface& surface);
  // change(scene) of the present one.
  template <class Change>
  void send(const QString& name, const QString& mergeKey, bool endsAfterPause, const Change& change);

  VolumePointer volume_;
  scene::Scene scene_;
  std::vector<app::ListedSurface> list_;
  std::vector<Row> rows_;
  QGridLayout* grid_;
  QLineEdit* search_;
  QFrame* place_;  // where a dragged row would go
};

// Returns what it is called: its name, or "Isosurface 2", "Labels 4-7", "Other labels".
QString surfaceName(const app::ListedSurface& surface);

}  // namespace isolux::ui
