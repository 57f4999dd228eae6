#include "ui/editors/environment_preview.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <glm/mat3x3.hpp>

#include "app/view_math/turning.h"
#include "base/color.h"
#include "scene/camera.h"
#include "scene/rules/environment.h"
#include "ui/document/environment_edit.h"
#include "ui/theme/style.h"

namespace isolux::ui {

namespace {
constexpr double pi = std::numbers::pi;
constexpr double stepDegrees = 5.0;  // of an arrow key

std::uint8_t screenValue(double c) {  // Reinhard's curve, then sRGB
  return base::screenByte(c / (1.0 + c));
}
// Of what is loaded: the same for all that differs in nothing but how it is turned and brightened.
std::string nameOf(const scene::Environment& environment) {
  if (scene::kindOf(environment) == scene::EnvironmentKind::file) return environment.file;
  return "built-in/" + std::to_string(static_cast<int>(environment.builtIn));
}
}  // namespace

EnvironmentPreview::EnvironmentPreview(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setMinimumSize(120, 60);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
  setAccessibleName(tr("Environment map"));
}

// The probe

void EnvironmentPreview::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  const scene::Environment &was = resolved_.light.environment, &is = resolved.light.environment;
  if (scene::rotationOf(was, axes_) != scene::rotationOf(is, axes_) || was.exposure != is.exposure)
    image_ = {};
  scene_ = scene;
  resolved_ = resolved;
  load();
  if (isVisible()) update();
}

void EnvironmentPreview::load() {
  // Only what lights something is worth its loading.
  const scene::Environment& environment = resolved_.light.environment;
  const std::string wanted = whyItCannotTurn(resolved_).isEmpty() ? nameOf(environment) : "";
  if (wanted == name_) return;
  name_ = wanted;
  thumbnail_ = {};
  image_ = {};
  problem_.clear();
  setToolTip({});
  task_.reset();
  if (name_.empty()) return;
  task_.watch(app::probeTask(environment), [this](auto& task) { take(task); });
}

void EnvironmentPreview::take(app::ProbeTask& task) {
  if (task.error()) {
    problem_ = QString::fromStdString(task.error()->reason());
    Q_EMIT failed(QString::fromStdString(task.error()->what()));
  } else {
    thumbnail_ = std::move(task.value());
    setToolTip(
        tr("Drag to turn the environment about the vertical axis. The cross marks the view direction."));
  }
  update();
}

// Painting

QPointF EnvironmentPreview::placeOf(glm::dvec3 direction) const {
  const double x = std::atan2(direction.x, direction.y) / (2.0 * pi) + 0.5;
  const double y = std::acos(std::clamp(direction.z, -1.0, 1.0)) / pi;
  return {x * width(), y * height()};
}

void EnvironmentPreview::draw() {
  const QSize size = this->size().boundedTo({640, 320}).expandedTo({1, 1});
  image_ = QImage(size, QImage::Format_RGB32);
  const glm::dvec4 rotation = scene::rotationOf(resolved_.light.environment, axes_);
  const glm::dmat3 environmentFromWorld(app::rotatedBack(rotation, {1, 0, 0}),
                                        app::rotatedBack(rotation, {0, 1, 0}),
                                        app::rotatedBack(rotation, {0, 0, 1}));
  const double mean = thumbnail_.meanLuminance;
  const double scale = (mean > 0.0 ? 0.5 / mean : 1.0) * std::exp2(resolved_.light.environment.exposure);
  std::vector<glm::dvec2> azimuths;
  for (int x = 0; x < size.width(); ++x) {
    const double phi = 2.0 * pi * ((x + 0.5) / size.width() - 0.5);
    azimuths.emplace_back(std::sin(phi), std::cos(phi));
  }
  for (int y = 0; y < size.height(); ++y) {
    const double theta = pi * (y + 0.5) / size.height(), sine = std::sin(theta), cosine = std::cos(theta);
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(y));
    for (int x = 0; x < size.width(); ++x) {
      const glm::dvec2& azimuth = azimuths[static_cast<std::size_t>(x)];
      const glm::dvec3 world(sine * azimuth.x, sine * azimuth.y, cosine);
      const glm::dvec3 c = scale * glm::dvec3(thumbnail_.at(environmentFromWorld * world));
      line[x] = qRgb(screenValue(c.x), screenValue(c.y), screenValue(c.z));
    }
  }
}

void EnvironmentPreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  if (!loaded()) {
    painter.fillRect(rect(), colours.base);
    painter.setPen(problem_.isEmpty() ? colours.quietText : colours.error);
    painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignCenter | Qt::TextWordWrap,
                     problem_.isEmpty() ? tr("Loading the environment…") : problem_);
    return;
  }
  if (image_.isNull()) draw();
  painter.drawImage(rect(), image_);
  paintMarks(painter);
  if (hasFocus()) {
    painter.setPen(QPen(colours.accent, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void EnvironmentPreview::paintMarks(QPainter& painter) const {
  const auto rimmed = [&](const QPainterPath& path, double thickness) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 190), thickness + 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(path);
    painter.setPen(QPen(Qt::white, thickness, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(path);
  };
  const QPointF looks = placeOf(-scene::frameOf(resolved_.camera).back);
  QPainterPath cross;
  for (const QPointF arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
    cross.moveTo(looks + 2.5 * arm);
    cross.lineTo(looks + 7.5 * arm);
  }
  rimmed(cross, 1.5);

  QFont small = font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  small.setWeight(QFont::DemiBold);
  const QFontMetricsF metrics(small);
  struct Mark {
    glm::dvec3 direction;
    double place;  // of the width
  };
  for (const Mark& mark : {Mark{{-1, 0, 0}, 0.25}, Mark{{0, 1, 0}, 0.5}, Mark{{1, 0, 0}, 0.75}}) {
    const QString text = QString::fromStdString(axisEnd(axes_, mark.direction));
    QPainterPath letter;
    letter.addText(mark.place * width() - 0.5 * metrics.horizontalAdvance(text), height() - 4.0, small, text);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(letter);
    painter.fillPath(letter, Qt::white);
  }
}

void EnvironmentPreview::setAxes(scene::WorldAxes axes) {
  axes_ = axes;
  image_ = {};
  update();
}

// Turning

void EnvironmentPreview::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !hasProbe()) return;
  dragging_ = true;
  last_ = event->position();
  Q_EMIT dragStarted();
}

void EnvironmentPreview::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) return;
  if (!(event->buttons() & Qt::LeftButton)) {  // it was let go elsewhere
    endDrag();
    return;
  }
  const double step = event->position().x() - last_.x();
  if (step == 0.0) return;
  last_ = event->position();
  // To the right is clockwise as seen from above.
  const double degrees = -360.0 * step / std::max(1, width());
  Q_EMIT edited(environmentTurnedBy(scene_, degrees));
}

void EnvironmentPreview::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && dragging_) endDrag();
}

void EnvironmentPreview::endDrag() {
  dragging_ = false;
  Q_EMIT dragEnded();
}

void EnvironmentPreview::keyPressEvent(QKeyEvent* event) {
  const int direction = event->key() == Qt::Key_Right ? -1 : event->key() == Qt::Key_Left ? 1 : 0;
  if (direction == 0 || !hasProbe()) {
    QWidget::keyPressEvent(event);
    return;
  }
  Edit edit = environmentTurnedBy(scene_, direction * stepDegrees);
  edit.endsAfterPause = true;
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
