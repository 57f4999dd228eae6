#include "ui/viewport/viewport_overlay.h"

#include <algorithm>
#include <utility>

#include <QPainter>
#include <QPainterPath>
#include <QPixmapCache>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/overlay_text/annotation.h"
#include "app/overlay_text/free_places.h"
#include "base/color.h"
#include "ui/language/number_text.h"
#include "ui/theme/style.h"

namespace isolux::ui {

namespace {
// Pixels.
constexpr double halfEdge = 17.0;  // of the cube
constexpr double cubeInset = 48.0,
                 cubeReach = 29.0;  // its middle from the corner, and how far it reaches turned
constexpr double letterMargin = 12.0, noteTop = 36.0, textRim = 1.5;
constexpr double barTick = 6.0, barLift = 11.0;  // of the scale bar: its ends, and its text over the line

app::TextBox boxOf(const QRectF& rect) {
  return {{rect.x(), rect.y()}, {rect.width(), rect.height()}};
}

QRectF rectOf(const app::TextBox& box) {
  return {box.low.x, box.low.y, box.size.x, box.size.y};
}
}  // namespace

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
  set(camera_, resolved.camera);
  set(backgroundTop_, resolved.look.backgroundTop);
  set(backgroundBottom_, resolved.look.backgroundBottom);
  set(visible_, visible);
  set(axes_, axes);
  if (visible) frame_ = scene::frameOf(camera_);
}

void ViewportOverlay::setProblem(const QString& reason, const QString& advice) {
  set(problem_, reason);
  set(advice_, advice);
  setAccessibleDescription(reason.isEmpty() ? note_ : reason + "\n\n" + advice);
}

void ViewportOverlay::setMarks(std::vector<app::MarkShape> marks, const QString& toolHint) {
  if (marks.empty() && marks_.empty() && toolHint == toolHint_) return;
  marks_ = std::move(marks);
  toolHint_ = toolHint;
  update();
}

std::vector<QRectF> ViewportOverlay::Arrangement::boxes() const {
  std::vector<QRectF> all;
  for (const QRectF& box : {cube, scale, note, toolHint, left, right, top, bottom})
    if (!box.isEmpty()) all.push_back(box);
  return all;
}

QFont ViewportOverlay::letterFont() const {
  QFont letters = font();
  letters.setPointSizeF(letters.pointSizeF() + 5.0);
  letters.setWeight(QFont::DemiBold);
  return letters;
}

QFont ViewportOverlay::scaleFont() const {
  QFont medium = font();
  medium.setWeight(QFont::Medium);
  return medium;
}

ViewportOverlay::Arrangement ViewportOverlay::arrangement() const {
  Arrangement found;
  const QRectF all = QRectF(rect()).adjusted(4.0, topInset_ + 4.0, -4.0, -4.0);
  app::FreePlaces free(boxOf(all), 3.0);
  for (const QRectF& box : taken_) free.take(boxOf(box));
  const auto place = [&](const QRectF& wanted, Qt::Orientation along) {
    const auto box = free.place(boxOf(wanted), along == Qt::Horizontal ? 0 : 1);
    return box ? rectOf(*box) : QRectF();
  };

  const QRectF cubeWanted(width() - cubeInset - cubeReach, topInset_ + cubeInset - cubeReach, 2.0 * cubeReach,
                          2.0 * cubeReach);
  found.cube = place(cubeWanted, Qt::Vertical);
  if (found.cube.isEmpty()) found.cube = cubeWanted;

  const double longest = std::min(140.0, 0.4 * width());
  if (const auto bar = app::scaleBarOf(frame_, height(), longest)) {
    found.scaleMm = bar->mm;
    found.scalePixels = bar->pixels;
    const QFontMetricsF metrics(scaleFont());
    const double wide = std::max(bar->pixels, metrics.horizontalAdvance(scaleText(bar->mm))) + 2.0 * textRim;
    const QSizeF size(wide, barLift + metrics.ascent() + 2.0 * textRim);
    const double margin = 17.0;
    const QPointF left(margin, height() - 19.0 - size.height());
    const QRectF atLeft(left, size), atRight({width() - margin - wide, left.y()}, size);
    found.scale = free.isFree(boxOf(atLeft)) || !free.isFree(boxOf(atRight)) ? place(atLeft, Qt::Vertical)
                                                                             : place(atRight, Qt::Vertical);
  }

  const QFontMetricsF metrics(font());
  const auto textBox = [&](const QStringList& text, double top) {
    double wide = 0.0;
    for (const QString& line : text) wide = std::max(wide, metrics.horizontalAdvance(line));
    return QRectF(0.5 * (width() - wide), top, wide,
                  metrics.lineSpacing() * static_cast<double>(text.size()));
  };
  if (!note_.isEmpty()) {
    const QRectF wanted = textBox(lines(note_), topInset_ + noteTop);
    found.note = place(wanted, Qt::Vertical);
    if (found.note.isEmpty()) found.note = wanted;
  }
  if (!toolHint_.isEmpty()) {
    const QStringList text = lines(toolHint_);
    const double high = metrics.lineSpacing() * static_cast<double>(text.size());
    found.toolHint = place(textBox(text, height() - 36.0 - high), Qt::Vertical);
  }

  for (const QLineF& line : sliceLines(slices_, frame_, size()))
    free.takeLine({line.x1(), line.y1()}, {line.x2(), line.y2()});
  const scene::EdgeLetters letters = scene::edgeLetters(frame_, axes_);
  const QFontMetricsF large(letterFont());
  const double high = large.capHeight(), middle = 0.5 * (height() - high);
  const auto edge = [&](const std::string& letter, double fraction, double y) {  // of the width
    const double wide = large.horizontalAdvance(QString::fromStdString(letter));
    const double room = width() - 2.0 * letterMargin - wide;
    return QRectF(letterMargin + fraction * room, y, wide, high);
  };
  found.left = place(edge(letters.left, 0.0, middle), Qt::Vertical);
  found.right = place(edge(letters.right, 1.0, middle), Qt::Vertical);
  found.top = place(edge(letters.top, 0.5, topInset_ + letterMargin), Qt::Horizontal);
  found.bottom = place(edge(letters.bottom, 0.5, height() - letterMargin - high), Qt::Horizontal);
  return found;
}

void ViewportOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  if (!problem_.isEmpty()) {
    paintProblem(painter);
  } else if (visible_) {
    const Arrangement places = arrangement();
    paintSlices(painter, slices_, frame_, size());
    if (!cuts_.empty()) paintCuts(painter, cuts_, cutGrip_);
    if (!marks_.empty()) {
      std::vector<QRectF> taken = places.boxes();
      taken.insert(taken.end(), taken_.begin(), taken_.end());
      paintMarks(painter, marks_, frame_, size(), std::move(taken));
    }
    paintLetters(painter, places);
    paintCube(painter, places.cube.center());
    paintScale(painter, places);
    paintLamps(painter, lamps_, grip_);
    if (!note_.isEmpty()) paintLines(painter, lines(note_), places.note.top());
    if (!places.toolHint.isEmpty()) paintLines(painter, lines(toolHint_), places.toolHint.top());
  } else if (!hint_.isEmpty()) {
    paintLines(painter, lines(hint_), 0.5 * height() - fontMetrics().ascent());
  }
}

void ViewportOverlay::setNote(const QString& text) {
  set(note_, text);
  if (problem_.isEmpty()) setAccessibleDescription(text);
}

// Broken between words.
QStringList ViewportOverlay::lines(const QString& text) const {
  const QFontMetricsF metrics(font());
  QStringList result;
  for (const QString& word : text.split(' ')) {
    if (!result.isEmpty() && metrics.horizontalAdvance(result.back() + ' ' + word) <= width() - 24.0)
      result.back() += ' ' + word;
    else
      result += word;
  }
  return result;
}

void ViewportOverlay::paintLines(QPainter& painter, const QStringList& lines, double top) const {
  const QFontMetricsF metrics(font());
  double baseline = top + metrics.ascent();
  for (const QString& line : lines) {
    drawText(painter, font(), QPointF(0.5 * (width() - metrics.horizontalAdvance(line)), baseline), line);
    baseline += metrics.lineSpacing();
  }
}

void ViewportOverlay::paintLetters(QPainter& painter, const Arrangement& places) const {
  const scene::EdgeLetters letters = scene::edgeLetters(frame_, axes_);
  const QFont font = letterFont();
  for (const auto& [letter, box] :
       {std::pair(&letters.left, places.left), std::pair(&letters.right, places.right),
        std::pair(&letters.top, places.top), std::pair(&letters.bottom, places.bottom)})
    if (!box.isEmpty()) drawText(painter, font, box.bottomLeft(), QString::fromStdString(*letter));
}

std::vector<app::CubeFace> ViewportOverlay::cube() const {
  return app::cubeFaces(frame_, axes_, halfEdge);
}

std::optional<scene::StandardView> ViewportOverlay::cubeViewAt(QPointF position) const {
  if (!visible_ || !problem_.isEmpty()) return std::nullopt;
  const QPointF from = position - arrangement().cube.center();
  return app::faceAt(cube(), {from.x(), from.y()});
}

void ViewportOverlay::pointAtCube(std::optional<QPointF> position) {
  const auto face = position ? cubeViewAt(*position) : std::nullopt;
  set(pointedFace_, face);
}

void ViewportOverlay::setSlices(SlicesInPicture slices) {
  if (slices.outlines.empty() && slices_.outlines.empty()) return;
  slices_ = std::move(slices);
  update();
}

void ViewportOverlay::paintCube(QPainter& painter, QPointF centre) const {
  QFont font = this->font();
  font.setPixelSize(20);
  font.setWeight(QFont::DemiBold);
  const QFontMetricsF metrics(font);
  const auto point = [](glm::dvec2 p) { return QPointF(p.x, p.y); };
  for (const app::CubeFace& face : cube()) {
    QPolygonF square;
    for (const glm::dvec2& corner : face.corners) square << centre + point(corner);
    const int shade = static_cast<int>(46.0 + 44.0 * face.facing);
    painter.setBrush(face.view == pointedFace_ ? colours.accent : QColor(shade, shade + 5, shade + 12, 225));
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

// In perspective a length holds at one depth only: that of the centre of rotation.
QString ViewportOverlay::scaleText(double mm) const {
  const QString length = valueText(mm, "mm");
  return frame_.projection == scene::Projection::perspective ? tr("%1 at the centre").arg(length) : length;
}

void ViewportOverlay::paintScale(QPainter& painter, const Arrangement& places) const {
  if (places.scale.isEmpty()) return;
  const double left = places.scale.left() + textRim, bottom = places.scale.bottom() - textRim,
               length = places.scalePixels;
  QPainterPath bar;
  bar.moveTo(left, bottom - barTick);
  bar.lineTo(left, bottom);
  bar.lineTo(left + length, bottom);
  bar.lineTo(left + length, bottom - barTick);
  painter.setBrush(Qt::NoBrush);
  const Inks inks = inksAt(bottom / std::max(1, height()));
  painter.setPen(QPen(inks.rim, 4.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawPath(bar);
  painter.setPen(QPen(inks.ink, 1.6, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawPath(bar);
  drawText(painter, scaleFont(), {left, bottom - barLift}, scaleText(places.scaleMm));
}

void ViewportOverlay::paintProblem(QPainter& painter) const {
  painter.fillRect(rect(), colours.base);
  QFont title = font();
  title.setPointSizeF(title.pointSizeF() + 4.0);
  title.setWeight(QFont::DemiBold);
  const QRectF box = QRectF(rect()).adjusted(40, 0, -40, 0);
  painter.setPen(colours.text);
  painter.setFont(title);
  painter.drawText(box.adjusted(0, 0, 0, -0.5 * height() - 8.0), Qt::AlignHCenter | Qt::AlignBottom,
                   tr("The image cannot be drawn"));
  painter.setPen(colours.quietText);
  painter.setFont(font());
  painter.drawText(box.adjusted(0, 0.5 * height() + 8.0, 0, 0), Qt::AlignHCenter | Qt::TextWordWrap,
                   problem_ + "\n\n" + advice_);
}

}  // namespace isolux::ui
