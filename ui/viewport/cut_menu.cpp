#include "ui/viewport/cut_menu.h"

#include <QActionGroup>
#include <QKeySequence>
#include <QMenu>
#include <QSettings>

#include <glm/geometric.hpp>

#include "app/cuts/cut_edits.h"
#include "scene/camera.h"
#include "scene/rules/needs.h"

namespace isolux::ui {

namespace {
constexpr auto handlesKey = "cuts/handles";
}  // namespace

CutMenu::CutMenu(QMenu* menu, QObject* parent) : QObject(parent) {
  menu->setToolTipsVisible(true);
  makeAdding(menu);
  menu->addSeparator();
  makePlanes(menu);
  menu->addSeparator();
  makeFaces(menu);
  makeSurfaces(menu);
  handles_ = add(menu, tr("Show &handles"), tr("Show handles of planes and box in the 3-D view"), {}, [this] {
    QSettings().setValue(handlesKey, showsHandles());
    Q_EMIT handlesShown(showsHandles());
  });
  handles_->setCheckable(true);
  handles_->setChecked(QSettings().value(handlesKey, true).toBool());
  menu->addSeparator();
  all_ = add(menu, tr("&Remove all cuts"), tr("Remove all planes and boxes"), QKeySequence("Shift+X"),
             [this] { removeAll(); });
  showState();
}

QAction* CutMenu::add(QMenu* menu, const QString& text, const QString& tip, const QKeySequence& keys,
                      const std::function<void()>& chosen) {
  QAction* action = menu->addAction(text, keys, this, chosen);
  action->setToolTip(tip);
  action->setData(tip);  // what allow() goes back to
  return action;
}

void CutMenu::allow(QAction* action, const QString& whyNot) {
  action->setEnabled(whyNot.isEmpty());
  action->setToolTip(whyNot.isEmpty() ? action->data().toString() : whyNot);
}

// Entries

void CutMenu::makeAdding(QMenu* menu) {
  const QString tip =
      tr("Add a plane through the crosshair or the view’s target, and cut away the part in front of it");
  for (const int axis : {2, 1, 0}) {
    QAction*& action = across_[static_cast<std::size_t>(axis)];
    action = add(menu, {}, tip, {}, [this, axis] { addAcross(axis); });
  }
  nameAxes();
  facing_ = add(menu, tr("Plane facing the &viewer"), tip, QKeySequence("C"), [this] { addFacing(); });
  through_ =
      add(menu, tr("Plane &through three points"),
          tr("Add a plane through the points of the selected measurement, or the last three points set"), {},
          [this] { addThrough(); });
  box_ = add(menu, tr("&Box"), tr("Add a box and cut away everything outside it"), {}, [this] { addBox(); });
  corner_ = add(menu, tr("Cut a c&orner away"),
                tr("Remove the eighth towards the viewer, from the crosshair or the centre of the view"), {},
                [this] { addCorner(); });
}

void CutMenu::makePlanes(QMenu* menu) {
  flipLast_ = add(menu, tr("Revers&e last plane"), tr("Cut away the other side of the plane"),
                  QKeySequence("Shift+C"), [this] {
                    changePlane(scene_.clip.planes.size() - 1,
                                tr("Reverse plane %1").arg(scene_.clip.planes.size()), app::flipped);
                  });
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    PlaneActions& plane = planes_[i];
    plane.menu = menu->addMenu(tr("Plane &%1").arg(i + 1));
    plane.menu->setToolTipsVisible(true);
    plane.flip = add(plane.menu, tr("Revers&e"), tr("Cut away the other side of the plane"), {},
                     [this, i] { changePlane(i, tr("Reverse plane %1").arg(i + 1), app::flipped); });
    plane.toAxis =
        add(plane.menu, tr("Align to the nearest &axis"), tr("Align its normal with an axis"), {}, [this, i] {
          changePlane(i, tr("Align plane %1").arg(i + 1), [this](const scene::ClipPlane& before) {
            return app::alignedToAxis(before, volume_->grid().geometry().corners());
          });
        });
    plane.toViewer =
        add(plane.menu, tr("Turn to the &viewer"), tr("Turn its normal towards the viewer"), {}, [this, i] {
          changePlane(i, tr("Turn plane %1 to the viewer").arg(i + 1),
                      [this](const scene::ClipPlane& before) {
                        return app::alignedToViewer(before, volume_->grid().geometry().corners(), back());
                      });
        });
    plane.remove = add(plane.menu, tr("&Remove"), tr("Remove this plane"), {}, [this, i] { removePlane(i); });
  }
  boxMenu_ = menu->addMenu(tr("Bo&x"));
  straightenBox_ = add(boxMenu_, tr("&Align to the axes"), tr("Turn the box back to the axes"), {}, [this] {
    scene::Clip clip = scene_.clip;
    clip.boxRotation = {1.0, 0.0, 0.0, 0.0};
    send(clip, tr("Align the box"));
  });
  add(boxMenu_, tr("&Remove"), tr("Remove this box"), {}, [this] { removeBox(); });
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    corners_[i] = menu->addMenu(tr("Corner %1").arg(i + 1));
    corners_[i]->setToolTipsVisible(true);
    add(corners_[i], tr("&Remove"), tr("Restore this corner"), {}, [this, i] {
      scene::Clip clip = scene_.clip;
      app::removeCorner(clip, i);
      send(clip, tr("Remove corner %1").arg(i + 1));
    });
  }
}

void CutMenu::makeFaces(QMenu* menu) {
  QMenu* faces = menu->addMenu(tr("Cut &faces"));
  faces->setToolTipsVisible(true);
  faces_ = new QActionGroup(this);
  const auto choice = [&](scene::ClipCap cap, const QString& text, const QString& tip) {
    QAction* action = add(faces, text, tip, {}, [this, cap] {
      scene::Clip clip = scene_.clip;
      clip.cap = cap;
      send(clip, tr("Change cut faces"));
    });
    action->setCheckable(true);
    action->setProperty("cap", static_cast<int>(cap));
    faces_->addAction(action);
  };
  choice(scene::ClipCap::none, tr("&None"), tr("Leave the cut open and show the back faces of surfaces"));
  choice(scene::ClipCap::inside, tr("Values &inside"),
         tr("Show voxel values where the inside of a surface is cut"));
  choice(scene::ClipCap::whole, tr("&Whole slice"), tr("Show voxel values on the whole cap"));
}

void CutMenu::makeSurfaces(QMenu* menu) {
  surfacesMenu_ = menu->addMenu(tr("Cut s&urfaces"));
  surfacesMenu_->setToolTipsVisible(true);
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    surfaces_[i] =
        add(surfacesMenu_, tr("Isosurface &%1").arg(i + 1), tr("Let planes and box cut this surface"), {},
            [this, i] { setCut(static_cast<int>(i), surfaces_[i]->isChecked()); });
    surfaces_[i]->setCheckable(true);
  }
}

// State

void CutMenu::setVolume(const VolumePointer& volume) {
  volume_ = volume;
  nameAxes();
  showState();
}

void CutMenu::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  resolved_ = resolved;
  showState();
}

void CutMenu::nameAxes() {
  const bool anatomical = !volume_ || volume_->volume.axes == scene::WorldAxes::anatomical;
  across_[2]->setText(anatomical ? tr("&Axial plane") : tr("Plane across &Z"));
  across_[1]->setText(anatomical ? tr("&Coronal plane") : tr("Plane across &Y"));
  across_[0]->setText(anatomical ? tr("&Sagittal plane") : tr("Plane across &X"));
}

QString CutMenu::whyNoPlane() const {
  if (!volume_) return tr("Open a volume first.");
  if (scene_.clip.planes.size() >= scene::kClipPlanes)
    return tr("At most %1 planes are possible: remove one first.").arg(scene::kClipPlanes);
  return {};
}

void CutMenu::showState() {
  const scene::Clip& clip = scene_.clip;
  const bool boxed = !clip.box.empty(), cuts = scene::hasCuts(clip);
  const QString noVolume = volume_ ? QString() : tr("Open a volume first.");
  const QString noPlane = whyNoPlane(),
                noCut = cuts ? QString() : tr("Nothing is cut: add a plane or a box first.");
  for (QAction* action : {across_[0], across_[1], across_[2], facing_}) allow(action, noPlane);
  const bool marked = threePoints().size() == 3;
  allow(through_, !noPlane.isEmpty() ? noPlane
                  : marked           ? QString()
                                     : tr("Set three points first, with a tool of the Measure menu."));
  allow(box_, boxed ? tr("The scene already has a box: drag its faces.") : noVolume);
  const bool full = clip.removed.size() >= 2 * scene::kRemovedBoxes;
  allow(corner_, full ? tr("At most %1 corners: remove one first.").arg(scene::kRemovedBoxes) : noVolume);
  allow(flipLast_, clip.planes.empty() ? tr("The scene has no plane.") : noVolume);
  for (std::size_t i = 0; i < planes_.size(); ++i)
    planes_[i].menu->menuAction()->setVisible(volume_ && i < clip.planes.size());
  boxMenu_->menuAction()->setVisible(boxed);
  for (std::size_t i = 0; i < corners_.size(); ++i)
    corners_[i]->menuAction()->setVisible(volume_ && 2 * i < clip.removed.size());
  allow(straightenBox_,
        clip.boxRotation == glm::dvec4(1.0, 0.0, 0.0, 0.0) ? tr("The box is not turned.") : QString());
  for (QAction* action : faces_->actions()) {
    allow(action, noCut);
    action->setChecked(action->property("cap").toInt() == static_cast<int>(clip.cap));
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const bool there = i < scene_.surfaces.size();
    surfaces_[i]->setVisible(there && (i == 0 || scene_.surfaces[i].shown));
    surfaces_[i]->setChecked(there && scene_.surfaces[i].clipped);
    allow(surfaces_[i], noCut);
  }
  allow(handles_, noCut);
  allow(all_, noCut);
}

void CutMenu::showMenuOf(const QPoint& onScreen, const app::CutGrip& grip) {
  if (grip.plane > 0)
    planes_[static_cast<std::size_t>(grip.plane - 1)].menu->popup(onScreen);
  else if (grip.plane < 0)
    corners_[static_cast<std::size_t>(-grip.plane - 1)]->popup(onScreen);
  else
    boxMenu_->popup(onScreen);
}

// Edits

glm::dvec3 CutMenu::back() const {
  return scene::frameOf(resolved_.camera).back;
}

void CutMenu::send(const scene::Clip& clip, const QString& name) {
  Edit edit{scene_, name, {}, false};
  edit.scene.clip = clip;
  Q_EMIT edited(edit);
}

void CutMenu::addPlane(const scene::ClipPlane& plane, const QString& name) {
  scene::Clip clip = scene_.clip;
  clip.planes.push_back(plane);
  send(clip, name);
}

void CutMenu::addAcross(int axis) {
  addPlane(app::planeAcross(axis, app::cutPoint(resolved_, volume_->facts), back()),
           across_[static_cast<std::size_t>(axis)]->text().remove('&'));
}

void CutMenu::addFacing() {
  addPlane(app::planeFacing(back(), app::cutPoint(resolved_, volume_->facts)), tr("Plane facing the viewer"));
}

// The points of the chosen mark where it has three, else the last that were marked.
std::vector<glm::dvec3> CutMenu::threePoints() const {
  const int chosen = chosenMark_();
  if (chosen >= 0 && static_cast<std::size_t>(chosen) < scene_.marks.size())
    if (const auto& points = scene_.marks[static_cast<std::size_t>(chosen)].points; points.size() == 3)
      return points;
  return app::lastMarked(scene_.marks, 3);
}

void CutMenu::addThrough() {
  const std::vector<glm::dvec3> points = threePoints();
  if (points.size() != 3) return;
  const auto plane = app::planeThrough(std::span<const glm::dvec3, 3>(points.data(), 3), back());
  if (plane)
    addPlane(*plane, tr("Plane through three points"));
  else
    Q_EMIT failed(tr("The three points are collinear: set another point off their line."));
}

void CutMenu::changePlane(std::size_t plane, const QString& name,
                          const std::function<scene::ClipPlane(const scene::ClipPlane&)>& change) {
  if (plane >= scene_.clip.planes.size()) return;
  scene::Clip clip = scene_.clip;
  clip.planes[plane] = change(clip.planes[plane]);
  send(clip, name);
}

void CutMenu::removePlane(std::size_t plane) {
  if (plane >= scene_.clip.planes.size()) return;
  scene::Clip clip = scene_.clip;
  clip.planes.erase(clip.planes.begin() + static_cast<std::ptrdiff_t>(plane));
  send(clip, tr("Remove plane %1").arg(plane + 1));
}

void CutMenu::addBox() {
  scene::Clip clip = scene_.clip;
  app::addBox(clip, volume_->facts);
  send(clip, tr("Box"));
}

void CutMenu::removeBox() {
  scene::Clip clip = scene_.clip;
  clip.box.clear();
  clip.boxRotation = {1.0, 0.0, 0.0, 0.0};
  send(clip, tr("Remove the box"));
}

void CutMenu::addCorner() {
  scene::Clip clip = scene_.clip;
  app::addCorner(clip, app::cutPoint(resolved_, volume_->facts), back(),
                 volume_->grid().geometry().corners());
  send(clip, tr("Cut a corner away"));
}

void CutMenu::removeAll() {
  scene::Clip clip;
  clip.cap = scene_.clip.cap;
  send(clip, tr("Remove all cuts"));
}

void CutMenu::setCut(int surface, bool cut) {
  Edit edit{
      scene_, (cut ? tr("Cut isosurface %1") : tr("Do not cut isosurface %1")).arg(surface + 1), {}, false};
  edit.scene.surfaces.at(static_cast<std::size_t>(surface)).clipped = cut;
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
