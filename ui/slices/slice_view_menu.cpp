// The menu of ui/slices/slice_view.h: one more isosurface, which plane it shows, level and width for kinds of
// tissue, thick slab, convention.
#include <cmath>
#include <functional>

#include <QMenu>

#include "app/surface_list/surface_list.h"
#include "ui/language/number_text.h"
#include "ui/slices/oblique_dialog.h"
#include "ui/slices/slice_view.h"
#include "volume/field/reconstruct.h"

namespace isolux::ui {

namespace {

struct NamedWindow {
  const char* name;
  double level, width;  // HU
};
constexpr NamedWindow ctWindows[] = {{QT_TRANSLATE_NOOP("QObject", "Bone"), 500, 2000},
                                     {QT_TRANSLATE_NOOP("QObject", "Soft tissue"), 40, 400},
                                     {QT_TRANSLATE_NOOP("QObject", "Brain"), 40, 80},
                                     {QT_TRANSLATE_NOOP("QObject", "Lung"), -600, 1500},
                                     {QT_TRANSLATE_NOOP("QObject", "Angiography"), 300, 600}};
constexpr double slabsMm[] = {0.0, 2.0, 5.0, 10.0, 20.0, 40.0};

using Change = std::function<void(scene::Slice&)>;
using Kind = app::SliceChoice::Kind;

void addChoice(QMenu* menu, SliceView& view, const QString& text, bool checked,
               const std::function<void()>& choose) {
  QAction* const action = menu->addAction(text, &view, choose);
  action->setCheckable(true);
  action->setChecked(checked);
}

void addChange(QMenu* menu, SliceView& view, const QString& text, const QString& undoName, bool checked,
               const Change& change) {
  addChoice(menu, view, text, checked, [&view, undoName, change] {
    Edit edit{view.scene(), undoName};
    change(edit.scene.slice);
    Q_EMIT view.edited(edit);
  });
}

// One more isosurface, of the value there.
void addSurface(QMenu* menu, SliceView& view, glm::dvec3 worldMm) {
  const volume::PreparedVolume& volume = *view.volume();
  const glm::dvec3 voxel = volume.grid().geometry().voxelOf(worldMm);
  const double value = volume::sampleTrilinear(volume.grid(), voxel).value;
  if (!std::isfinite(value)) return;
  const std::optional<scene::Scene> added = app::withSurface(view.scene(), volume, value);
  const QString text = valueText(value, QString::fromStdString(volume.volume.unit));
  const auto add = [&view, added] { Q_EMIT view.edited({*added, QObject::tr("Add isosurface")}); };
  menu->addAction(QObject::tr("Add isosurface at this value, %1").arg(text), &view, add)
      ->setEnabled(added.has_value());
}

void addWindows(QMenu* menu, SliceView& view) {
  const scene::Slice& now = view.scene().slice;
  const QString undoName = QObject::tr("Change window level and width");
  const auto add = [&](const QString& name, std::optional<double> level, std::optional<double> width) {
    addChange(menu, view, name, undoName, now.level == level && now.width == width,
              [level, width](scene::Slice& slice) {
                slice.level = level;
                slice.width = width;
              });
  };
  menu->addSection(QObject::tr("Window level and width"));
  add(QObject::tr("Automatic"), std::nullopt, std::nullopt);
  if (view.volume()->volume.unit != "HU") return;
  for (const NamedWindow& named : ctWindows) add(QObject::tr(named.name), named.level, named.width);
}

void addPlanes(QMenu* menu, SliceView& view) {
  const app::SliceChoice now = view.choice();
  const auto add = [&](const QString& text, const app::SliceChoice& choice) {
    addChoice(menu, view, text, choice == now, [&view, choice] { view.choose(choice); });
  };
  using volume::SliceDirection;
  menu->addSection(QObject::tr("Plane"));
  add(QObject::tr("Axial"), {.direction = SliceDirection::axial});
  add(QObject::tr("Coronal"), {.direction = SliceDirection::coronal});
  add(QObject::tr("Sagittal"), {.direction = SliceDirection::sagittal});
  for (std::size_t i = 0; i < view.scene().clip.planes.size(); ++i)
    add(QObject::tr("Cut %1").arg(i + 1), {.kind = Kind::cut, .cut = i});
  addChoice(menu, view, QObject::tr("Oblique…"), now.kind == Kind::oblique, [&view] { askForPlane(view); });
}

void addSlabs(QMenu* menu, SliceView& view) {
  const scene::Slice& now = view.scene().slice;
  QMenu* const slabs = menu->addMenu(QObject::tr("Slab"));
  const QString undoName = QObject::tr("Change slab");
  for (const double mm : slabsMm)
    addChange(slabs, view, mm == 0.0 ? QObject::tr("None (plane only)") : valueText(mm, "mm"), undoName,
              now.slab == mm, [mm](scene::Slice& slice) { slice.slab = mm; });
  slabs->addSeparator();
  using scene::SlabMode;
  for (const auto& [mode, name] : {std::pair{SlabMode::mean, QObject::tr("Average")},
                                   std::pair{SlabMode::maximum, QObject::tr("Maximum (MIP)")},
                                   std::pair{SlabMode::minimum, QObject::tr("Minimum (MinIP)")}})
    addChange(slabs, view, name, undoName, now.slabMode == mode,
              [chosen = mode](scene::Slice& slice) { slice.slabMode = chosen; });
}

void addConventions(QMenu* menu, SliceView& view) {
  if (view.volume()->volume.axes != scene::WorldAxes::anatomical) return;
  QMenu* const conventions = menu->addMenu(QObject::tr("Convention"));
  using scene::Convention;
  for (const auto& [convention, name] :
       {std::pair{Convention::radiological, QObject::tr("Radiological: the patient's right on the left")},
        std::pair{Convention::neurological, QObject::tr("Neurological: the patient's left on the left")}})
    addChange(conventions, view, name, QObject::tr("Change convention"),
              view.scene().slice.convention == convention,
              [chosen = convention](scene::Slice& slice) { slice.convention = chosen; });
}

}  // namespace

QMenu* makeSliceMenu(SliceView& view, glm::dvec3 worldMm) {
  auto* menu = new QMenu(&view);
  menu->setObjectName("slice");
  addSurface(menu, view, worldMm);
  addPlanes(menu, view);
  addWindows(menu, view);
  menu->addSeparator();
  addSlabs(menu, view);
  const bool contours = view.scene().slice.contourWidth > 0.0;
  addChange(
      menu, view, QObject::tr("Isocontours"), QObject::tr("Change isocontours"), contours,
      [contours](scene::Slice& slice) { slice.contourWidth = contours ? 0.0 : scene::Slice{}.contourWidth; });
  addConventions(menu, view);
  menu->addSeparator();
  menu->addAction(QObject::tr("Show the whole slice"), &view, &SliceView::showWhole);
  return menu;
}

}  // namespace isolux::ui
