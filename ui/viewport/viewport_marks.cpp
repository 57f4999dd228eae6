// Marks of ui/viewport/viewport.h: clicks that set points, and what of the marks is behind the surface.
#include <QElapsedTimer>
#include <QKeyEvent>

#include <glm/geometric.hpp>

#include "app/marks/mark_kinds.h"
#include "app/ready/rest_scene.h"
#include "ui/language/translated.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_overlay.h"

namespace isolux::ui {

namespace {

constexpr int hiddenMilliseconds = 4;  // of looking what is behind the surface, in one turn of the event loop

// In the order of scene::MarkKind.
constexpr const char* kWhatToClick[] = {
    QT_TRANSLATE_NOOP("QObject", "Pin: click on the surface"),
    QT_TRANSLATE_NOOP("QObject", "Distance: click two points; Shift adds more"),
    QT_TRANSLATE_NOOP("QObject", "Geodesic distance: click two points; Shift adds more"),
    QT_TRANSLATE_NOOP("QObject",
                      "Angle: click three points, the vertex second; Shift at the third measures "
                      "between two lines"),
    QT_TRANSLATE_NOOP("QObject", "Circle: click three points"),
    QT_TRANSLATE_NOOP("QObject", "Thickness: click on the surface"),
    QT_TRANSLATE_NOOP("QObject", "Piece: click on a piece")};

}  // namespace

void Viewport::setTool(std::optional<scene::MarkKind> tool) {
  if (tool == tool_) return;
  tool_ = tool;
  placing_.clear();
  placingAt_.reset();
  if (tool_)
    setCursor(Qt::CrossCursor);
  else
    unsetCursor();
  showMarks();
  showCuts();
  Q_EMIT toolChanged();
}

void Viewport::setMarks(const std::vector<scene::Mark>& marks, const std::vector<app::MarkReport>& reports) {
  shapes_.clear();
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i].shown) shapes_.push_back(app::markShape(marks[i], reports[i]));
  marksSeenFrom_ = 0;
  lookBehindMarks();
  showMarks();
}

// What is being placed follows the pointer, with the straight distance that it has by now.
void Viewport::showMarks() {
  std::vector<app::MarkShape> shapes = shapes_;
  if (tool_ && !placing_.empty()) {
    scene::Mark mark{*tool_, {}, placing_};
    if (placingAt_) mark.points.push_back(*placingAt_);
    app::MarkReport report;
    if (mark.points.size() > 1 && (*tool_ == scene::MarkKind::distance || *tool_ == scene::MarkKind::path)) {
      app::MarkQuantity& straight =
          report.quantities.emplace_back(app::MarkQuantity{"straight", 0, {}, "mm"});
      for (std::size_t i = 1; i < mark.points.size(); ++i)
        straight.value += glm::distance(mark.points[i - 1], mark.points[i]);
    }
    shapes.push_back(app::markShape(mark, report));
  }
  QString hint;
  if (tool_)
    hint = tr("%1.  Backspace removes the last point; Esc ends")
               .arg(QObject::tr(kWhatToClick[static_cast<std::size_t>(*tool_)]));
  overlay_->setMarks(std::move(shapes), hint);
}

// A few milliseconds at a time: the rest in the next turns of the event loop.
void Viewport::lookBehindMarks() {
  if (!volume_ || shapes_.empty() || !hasContext_) return;
  QElapsedTimer timer;
  timer.start();
  const scene::Scene shown = shownAtRest_ ? app::atRestIfReady(resolved_, *volume_) : resolved_;
  const double aspect = static_cast<double>(pixelSize().x) / pixelSize().y;
  std::size_t number = 0;
  bool looked = false;  // at one at least
  const auto look = [&](app::MarkLine& line) {
    line.hidden.resize(line.corners.size());
    for (std::size_t i = 0; i < line.corners.size(); ++i) {
      if (number++ < marksSeenFrom_) continue;
      if (looked && timer.elapsed() >= hiddenMilliseconds) return false;
      looked = true;
      line.hidden[i] = app::isBehindSurface(*volume_, shown, line.corners[i], aspect);
      marksSeenFrom_ = number;
    }
    return true;
  };
  for (app::MarkShape& shape : shapes_) {
    bool goesOn = look(shape.points);
    for (app::MarkLine& line : shape.lines) goesOn = goesOn && look(line);
    if (goesOn) continue;
    QTimer::singleShot(0, this, [this] {
      lookBehindMarks();
      showMarks();
    });
    return;
  }
}

void Viewport::placePoint(QPointF position, bool more) {
  const auto pick = pickAt(position);
  if (!pick) return;
  placing_.push_back(pick->worldMm);
  placingAt_.reset();
  const app::MarkKindInfo& info = app::markKind(*tool_);
  if (placing_.size() >= info.most || (placing_.size() >= info.fewest && !more)) {
    Edit edit{scene_,
              tr("Add %1").arg(translated(texts::marks, QString(info.title).toLower().toStdString())),
              {},
              false};
    edit.scene.marks.push_back(
        {*tool_, app::freshName(translated(texts::marks, info.title).toStdString(), scene_.marks),
         std::move(placing_)});
    if (!slices_.outlines.empty()) edit.scene.slice.position = pick->worldMm;
    placing_.clear();
    Q_EMIT edited(edit);
  }
  showMarks();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  if (drag_ == Drag::cut && event->key() == Qt::Key_Escape) return cancelCut();
  if (turnByKey(*event)) return;
  if (tool_ && event->key() == Qt::Key_Escape) return setTool(std::nullopt);
  if (!tool_ || event->key() != Qt::Key_Backspace) return QWidget::keyPressEvent(event);
  if (!placing_.empty()) placing_.pop_back();
  showMarks();
}

// Esc leaves the full screen, too: a cut that is being dragged and the tool come first.
bool Viewport::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && (tool_ || drag_ == Drag::cut)) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape || (tool_ && key == Qt::Key_Backspace)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

}  // namespace isolux::ui
