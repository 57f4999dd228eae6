// First steps of ui/window/main_window.h: hints at the first start, and the tour (ui/tour).
#include <memory>

#include <QComboBox>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QToolBar>

#include "ui/panels/isovalue_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/tour/tour.h"
#include "ui/tour/tour_card.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

namespace isolux::ui {

namespace {

constexpr auto greetedKey = "hints/seen";

QRect placeIn(const QWidget* window, const QWidget* widget) {
  if (widget == nullptr || !widget->isVisible()) return {};
  return {widget->mapTo(window, QPoint(0, 0)), widget->size()};
}

}  // namespace

void MainWindow::greet() {
  if (QSettings().value(greetedKey, false).toBool()) return;
  auto* const card = new TourCard(this);
  greeting_ = card;
  greeting_->setButtons(tr("Start tour"), tr("Got it"));
  const auto present = [this] {
    if (!greeting_ || document_->loading()) return;
    greeting_->presentIn(
        placeIn(this, viewport_).adjusted(4, 4, -4, -56), tr("Welcome to Isolux"),
        tr("<ul style='margin-left:-24px'><li>Drag in the view to rotate it; the wheel zooms.</li><li>Drag "
           "the line in the histogram below to choose the surface.</li><li>To open your own scan, drop its "
           "file or folder here, or press Ctrl+O.</li></ul>"));
  };
  const auto leave = [this] {
    QSettings().setValue(greetedKey, true);
    if (greeting_) greeting_->deleteLater();
    greeting_.clear();
  };
  connect(card->leaveButton(), &QPushButton::clicked, this, leave);
  connect(card->nextButton(), &QPushButton::clicked, this, [this, leave] {
    leave();
    startTour();
  });
  connect(document_, &Document::opened, card, [leave](const QString& path) {
    if (!path.startsWith("phantom:")) leave();  // found the way
  });
  // The card of a load takes its place meanwhile.
  connect(document_, &Document::loadStarted, card, &QWidget::hide);
  connect(document_, &Document::loadEnded, card, present);
  connect(viewport_, &Viewport::resized, card, present, Qt::QueuedConnection);
  // The window may get its size only now, and docks with it.
  QMetaObject::invokeMethod(card, present, Qt::QueuedConnection);
}

// Of the entry of the menu bar.
QRect MainWindow::placeOfMenu(const QAction* menu) const {
  const QRect entry = menuBar()->actionGeometry(const_cast<QAction*>(menu));
  return {menuBar()->mapTo(this, entry.topLeft()), entry.size()};
}

QRect MainWindow::placeOfTool(const QAction* action) const {
  for (const QToolBar* bar : findChildren<QToolBar*>())
    if (const QWidget* button = bar->widgetForAction(const_cast<QAction*>(action));
        button && button->isVisible())
      return placeIn(this, button);
  return {};
}

void MainWindow::startTour() {
  if (tour_) return;
  if (!document_->volume() && !document_->loading()) document_->open("phantom:head");
  // What a step compares with: the scene at its beginning.
  const auto before = std::make_shared<scene::Scene>();
  const auto remember = [this, before] { *before = document_->resolvedScene(); };
  const auto now = [this] { return document_->resolvedScene(); };
  const auto asked = std::make_shared<bool>(false);
  const std::vector<TourStep> steps = {
      {tr("Choose the surface"),
       tr("Drag the bright line in the histogram. The surface consists of all points with this "
          "value: in a CT, low values show skin, high ones bone."),
       [this] { return placeIn(this, isovalue_); },
       [now, before] { return now().surfaces.front().value != before->surfaces.front().value; }, remember},
      {tr("Rotate the view"),
       tr("Drag with the left button to rotate, with the middle one to pan; the wheel zooms. "
          "Keys 1 to 6 show the six sides; R resets the view."),
       [this] { return placeIn(this, viewport_); }, [now, before] { return now().camera != before->camera; },
       remember},
      {tr("Choose a look"),
       tr("This list sets what the colours show: the shaded surface, curvature, depth or global "
          "illumination. L selects the next look."),
       [this] { return placeIn(this, look_); },
       [now, before] { return now().look.mode != before->look.mode; }, remember},
      {tr("Look inside"),
       tr("Press F4, or choose View > Layout. The outline in each slice is the surface. Click in "
          "a slice to move the crosshair."),
       [this] {
         return slices_->slicesShown() ? placeIn(this, slices_) : placeOfMenu(viewMenu_->menuAction());
       },
       [this] { return slices_->slicesShown(); },
       {}},
      {tr("Save the result"),
       tr("Save the image with this button, or Ctrl+E. It can show orientation labels, a scale "
          "bar and the isovalue, and opens again as a session. (You may also cancel.)"),
       [this] { return placeOfTool(picture_); }, [asked] { return *asked; }, [asked] { *asked = false; }},
      {tr("End of the tour"),
       tr("Presets set suitable isovalues for CT and MR. Ctrl+F finds every setting. F1 lists "
          "mouse and keys. You can undo every change."),
       {},
       {},
       {}}};
  tour_ = new Tour(this, steps);
  connect(picture_, &QAction::triggered, tour_, [asked] { *asked = true; });
}

}  // namespace isolux::ui
