// The menu *Cut*: each entry is one edit; what cannot act is grey and says why.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <QAction>
#include <QObject>
#include <QString>

#include "app/cuts/cut_handles.h"
#include "ui/document/document.h"
#include "ui/document/edit.h"

class QActionGroup;
class QKeySequence;
class QMenu;

namespace isolux::ui {

class CutMenu : public QObject {
  Q_OBJECT
 public:
  // Fills the menu, which outlives it.
  CutMenu(QMenu* menu, QObject* parent);

  void setVolume(const VolumePointer& volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  // The mark that is chosen in the list of marks, -1 for none.
  void setChosenMark(std::function<int()> chosen) { chosenMark_ = std::move(chosen); }
  bool showsHandles() const { return handles_->isChecked(); }
  // Shows the menu of the plane or box of a handle.
  void showMenuOf(const QPoint& onScreen, const app::CutGrip& grip);

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void handlesShown(bool shown);
  void failed(const QString& message);

 private:
  struct PlaneActions {
    QMenu* menu;
    QAction *flip, *toAxis, *toViewer, *remove;
  };
  QAction* add(QMenu* menu, const QString& text, const QString& tip, const QKeySequence& keys,
               const std::function<void()>& chosen);
  void makeAdding(QMenu* menu);
  void makePlanes(QMenu* menu);
  void makeSurfaces(QMenu* menu);
  void makeFaces(QMenu* menu);
  static void allow(QAction* action, const QString& whyNot);
  void nameAxes();
  QString whyNoPlane() const;
  void showState();
  glm::dvec3 back() const;
  void addPlane(const scene::ClipPlane& plane, const QString& name);
  void addAcross(int axis);
  void addFacing();
  void addThrough();
  std::vector<glm::dvec3> threePoints() const;
  void changePlane(std::size_t plane, const QString& name,
                   const std::function<scene::ClipPlane(const scene::ClipPlane&)>& change);
  void removePlane(std::size_t plane);
  void addBox();
  void removeBox();
  void addCorner();
  void removeAll();
  void setCut(int surface, bool cut);  // 0: the first one
  void send(const scene::Clip& clip, const QString& name);

  VolumePointer volume_;
  scene::Scene scene_, resolved_;
  std::function<int()> chosenMark_ = [] { return -1; };
  QMenu *surfacesMenu_ = nullptr, *boxMenu_ = nullptr;
  std::array<QAction*, 3> across_{};  // the world's x, y, z
  QAction *facing_ = nullptr, *through_ = nullptr, *box_ = nullptr, *corner_ = nullptr, *flipLast_ = nullptr,
          *handles_ = nullptr, *straightenBox_ = nullptr, *all_ = nullptr;
  std::array<PlaneActions, scene::kClipPlanes> planes_{};
  std::array<QMenu*, scene::kRemovedBoxes> corners_{};
  std::array<QAction*, scene::kSurfaces> surfaces_{};
  QActionGroup* faces_ = nullptr;
};

}  // namespace isolux::ui
