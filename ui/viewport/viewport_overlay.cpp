#include "ui/viewport/viewport_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>
#include <QPainterPath>
#include <QPixmapCache>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/color.h"
#include "base/numbers.h"
#include "ui/editors/number_text.h"
#include "ui/viewport/cut_painter.h"
#include "ui/viewport/lamp_painter.h"
#include "ui/viewport/mark_painter.h"
#include "ui/window/style.h"

namespace isolux::ui {

namespace {
constexpr double halfEdge = 17.0;  // of the cube, pixels
}

ViewportOverlay::Inks ViewportOverlay::inksAt(double heightFraction) const {
  const QColor light(0xf4, 0xf6, 0xf8), dark(0x0a, 0x0c, 0x0f);
  const glm::dvec3 background = glm::mix(backgroundTop_, backgroundBottom_, heightFraction);
  // At this luminance black and white have about the same contrast.
  constexpr double middle = 0.18;
  Inks inks = base::luminance(background) < middle ? Inks{light, dark} : Inks{dark, light};
  inks.rim.setAlpha(210);
  return inks;
}

// Text with a rim: reads on the surface, too, whatever its brightness. Kept as an image, as stroking outlines
// takes milliseconds and the same letters come back with every frame.
void ViewportOverlay::drawText(QPainter& painter, const QFont& font, QPointF baseline,
                               const QString& text) const {
  constexpr double rimWidth = 3.0;
  const Inks inks = inksAt(baseline.y() / std::max(1, height()));
  const double ratio = painter.device()->devicePixelRatioF();
  const QString key = QString("rimmed %1 %2 %3 %4 %5")
                          .arg(font.key())
                          .arg(inks.ink.rgba())
                          .arg(inks.rim.rgba())
                          .arg(ratio)
                          .arg(text);
  QPainterPath path;
  path.addText({0.0, 0.0}, font, text);
  // In whole points, so that the letters lie alike in their pixels wherever they stand.
  const QRect bounds = path.boundingRect().marginsAdded(QMarginsF() + rimWidth).toAlignedRect();
  if (bounds.isEmpty()) return;
  QPixmap letters;
  if (!QPixmapCache::find(key, &letters)) {
    letters = QPixmap((QSizeF(bounds.size()) * ratio).toSize());
    letters.setDevicePixelRatio(ratio);
    letters.fill(Qt::transparent);
    QPainter inside(&letters);
    inside.setRenderHint(QPainter::Antialiasing);
    inside.translate(-bounds.topLeft());
    inside.setPen(QPen(inks.rim, rimWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    inside.setBrush(Qt::NoBrush);
    inside.drawPath(path);
    inside.fillPath(path, inks.ink);
    QPixmapCache::insert(key, letters);
  }
  painter.drawPixmap(baseline.toPoint() + bounds.topLeft(), letters);
}

ViewportOverlay::ViewportOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
}

void ViewportOverlay::setScene(const scene::Scene& resolved, bool visible, scene::WorldAxes axes) {
  const bool same = visible == visible_ && axes == axes_ && resolved.camera == camera_ &&
                    resolved.look.backgroundTop == backgroundTop_ &&
                    resolved.look.backgroundBottom == backgroundBottom_;
  if (same) return;
  camera_ = resolved.camera;
  backgroundTop_ = resolved.look.backgroundTop;
  backgroundBottom_ = resolved.look.backgroundBottom;
  visible_ = visible;
  axes_ = axes;
  if (visible) frame_ = scene::frameOf(camera_);
  update();
}

void ViewportOverlay::setProblem(const QString& reason, const QString& advice) {
  if (reason == problem_ && advice == advice_) return;
  problem_ = reason;
  advice_ = advice;
  setAccessibleDescription(reason.isEmpty() ? note_ : reason + "\n\n" + advice);
  update();
}

void ViewportOverlay::setTopInset(int pixels) {
  if (pixels == topInset_) return;
  topInset_ = pixels;
  update();
}

void ViewportOverlay::setHint(const QString& text) {
  hint_ = text;
  update();
}

void ViewportOverlay::setLamps(std::vector<app::LampHandle> lamps, const std::optional<app::LampGrip>& grip) {
  if (lamps == lamps_ && grip == grip_) return;
  lamps_ = std::move(lamps);
  grip_ = grip;
  update();
}

void ViewportOverlay::setCuts(std::vector<app::CutShape> cuts, const std::optional<app::CutGrip>& grip) {
  if (cuts == cuts_ && grip == cutGrip_) return;
  cuts_ = std::move(cuts);
  cutGrip_ = grip;
  update();
}

void ViewportOverlay::setMarks(std::vector<app::MarkShape> marks, const QString& toolHint) {
  if (marks.empty() && marks_.empty() && toolHint == toolHint_) return;
  marks_ = std::move(marks);
  toolHint_ = toolHint;
  update();
}

void ViewportOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  if (!problem_.isEmpty()) {
    paintProblem(painter);
  } else if (visible_) {
    paintSlices(painter, slices_, frame_, size());
    if (!cuts_.empty()) paintCuts(painter, cuts_, cutGrip_);
    if (!marks_.empty()) paintMarks(painter, marks_, frame_, size());
    paintLetters(painter);
    paintCube(painter);
    paintScale(painter);
    paintLamps(painter, lamps_, grip_);
    if (!note_.isEmpty()) paintNote(painter);
    if (!toolHint_.isEmpty()) paintToolHint(painter);
  } else if (!hint_.isEmpty()) {
    const QFontMetricsF metrics(font());
    drawText(painter, font(), QPointF(0.5 * (width() - metrics.horizontalAdvance(hint_)), 0.5 * height()),
             hint_);
  }
}

void ViewportOverlay::setNote(const QString& text) {
  if (text == note_) return;
  note_ = text;
  if (problem_.isEmpty()) setAccessibleDescription(text);
  update();
}

void ViewportOverlay::paintNote(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  const double belowLetter = topInset_ + 48.0;
  drawText(painter, font(), QPointF(0.5 * (width() - metrics.horizontalAdvance(note_)), belowLetter), note_);
}

void ViewportOverlay::paintToolHint(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  const QString text = metrics.elidedText(toolHint_, Qt::ElideRight, width() - 24.0);
  const double aboveLetter = height() - 40.0;
  drawText(painter, font(), QPointF(0.5 * (width() - metrics.horizontalAdvance(text)), aboveLetter), text);
}

void ViewportOverlay::paintLetters(QPainter& painter) const {
  const scene::EdgeLetters letters = scene::edgeLetters(frame_, axes_);
  QFont font = this->font();
  font.setPointSizeF(font.pointSizeF() + 5.0);
  font.setWeight(QFont::DemiBold);
  const QFontMetricsF metrics(font);
  const double margin = 12.0, x = 0.5 * width(), y = 0.5 * height() + 0.5 * metrics.capHeight();
  const auto text = [](const std::string& letter) { return QString::fromStdString(letter); };
  drawText(painter, font, {margin, y}, text(letters.left));
  drawText(painter, font, {width() - margin - metrics.horizontalAdvance(text(letters.right)), y},
           text(letters.right));
  drawText(painter, font,
           {x - 0.5 * metrics.horizontalAdvance(text(letters.top)), topInset_ + margin + metrics.capHeight()},
           text(letters.top));
  drawText(painter, font, {x - 0.5 * metrics.horizontalAdvance(text(letters.bottom)), height() - margin},
           text(letters.bottom));
}

QPointF ViewportOverlay::cubeMiddle() const {
  return {width() - 48.0, topInset_ + 48.0};  // the legend stands in the lower corner
}

std::vector<app::CubeFace> ViewportOverlay::cube() const {
  return app::cubeFaces(frame_, axes_, halfEdge);
}

std::optional<scene::StandardView> ViewportOverlay::cubeViewAt(QPointF position) const {
  if (!visible_ || !problem_.isEmpty()) return std::nullopt;
  const QPointF from = position - cubeMiddle();
  return app::faceAt(cube(), {from.x(), from.y()});
}

void ViewportOverlay::pointAtCube(std::optional<QPointF> position) {
  const auto face = position ? cubeViewAt(*position) : std::nullopt;
  if (face == pointedFace_) return;
  pointedFace_ = face;
  update();
}

void ViewportOverlay::setSlices(SlicesInPicture slices) {
  if (slices.outlines.empty() && slices_.outlines.empty()) return;
  slices_ = std::move(slices);
  update();
}

void ViewportOverlay::paintCube(QPainter& painter) const {
  QFont font = this->font();
  font.setPixelSize(20);
  font.setWeight(QFont::DemiBold);
  const QFontMetricsF metrics(font);
  const QPointF centre = cubeMiddle();
  const auto point = [](glm::dvec2 p) { return QPointF(p.x, p.y); };
  for (const app::CubeFace& face : cube()) {
    QPolygonF square;
    for (const glm::dvec2& corner : face.corners) square << centre + point(corner);
    const int shade = static_cast<int>(46.0 + 44.0 * face.facing);
    painter.setBrush(face.view == pointedFace_ ? colours::accent : QColor(shade, shade + 5, shade + 12, 225));
    painter.setPen(QPen(QColor(0xd5, 0xda, 0xe0, 200), 1.0));
    painter.drawPolygon(square);
    if (face.facing < 0.25) continue;
    // The letter lies on its face: path units of one pixel become face units.
    QPainterPath path;
    const QString letter = QString::fromStdString(face.letter);
    path.addText(-0.5 * metrics.horizontalAdvance(letter), 0.5 * metrics.capHeight(), font, letter);
    const glm::dvec2 r = face.right / halfEdge, u = face.up / halfEdge;
    const QPointF middle = centre + point(face.middle);
    const QTransform onFace(r.x, r.y, -u.x, -u.y, middle.x(), middle.y());
    painter.fillPath(onFace.map(path), QColor(0xf4, 0xf6, 0xf8));
  }
}

void ViewportOverlay::paintScale(QPainter& painter) const {
  const bool perspective = frame_.projection == scene::Projection::perspective;
  const double heightMm = 2.0 * frame_.halfHeight * (perspective ? frame_.distance : 1.0);
  const double pixelMm = heightMm / std::max(1, height());
  if (!(pixelMm > 0.0) || !std::isfinite(pixelMm)) return;
  const double lengthMm = base::niceBelow(140.0 * pixelMm);
  const double length = lengthMm / pixelMm;
  // In perspective a length holds at one depth only: that of the centre of rotation.
  const QString text =
      perspective ? tr("%1 at the centre").arg(valueText(lengthMm, "mm")) : valueText(lengthMm, "mm");

  const double left = 18.5, bottom = height() - 20.5;
  QPainterPath bar;
  bar.moveTo(left, bottom - 6.0);
  bar.lineTo(left, bottom);
  bar.lineTo(left + length, bottom);
  bar.lineTo(left + length, bottom - 6.0);
  painter.setBrush(Qt::NoBrush);
  const Inks inks = inksAt(bottom / std::max(1, height()));
  painter.setPen(QPen(inks.rim, 4.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawPath(bar);
  painter.setPen(QPen(inks.ink, 1.6, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawPath(bar);
  QFont font = this->font();
  font.setWeight(QFont::Medium);
  drawText(painter, font, {left, bottom - 11.0}, text);
}

void ViewportOverlay::paintProblem(QPainter& painter) const {
  painter.fillRect(rect(), colours::base);
  QFont title = font();
  title.setPointSizeF(title.pointSizeF() + 4.0);
  title.setWeight(QFont::DemiBold);
  const QRectF box = QRectF(rect()).adjusted(40, 0, -40, 0);
  painter.setPen(colours::text);
  painter.setFont(title);
  painter.drawText(box.adjusted(0, 0, 0, -0.5 * height() - 8.0), Qt::AlignHCenter | Qt::AlignBottom,
                   tr("The picture cannot be drawn"));
  painter.setPen(colours::quietText);
  painter.setFont(font());
  painter.drawText(box.adjusted(0, 0.5 * height() + 8.0, 0, 0), Qt::AlignHCenter | Qt::TextWordWrap,
                   problem_ + "\n\n" + advice_);
}

}  // namespace isolux::ui
