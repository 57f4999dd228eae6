#include "ui/accuracy/error_overlay_box.h"

#include <QComboBox>
#include <QLabel>

#include "ui/document/picture_pixels.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

bool sameLimit(const ErrorOverlayBox::Shown& a, const ErrorOverlayBox::Shown& b) {
  return a.limit == b.limit && a.shortestEdgeMm == b.shortestEdgeMm;
}

}  // namespace

ErrorOverlayBox::ErrorOverlayBox(QWidget* parent)
    : QWidget(parent), errors_(new QComboBox(this)), note_(wrappedLabel({}, this)) {
  errors_->addItem(tr("None"));
  errors_->addItem(tr("Depth (noise, discretisation)"), static_cast<int>(app::ErrorImage::noise));
  errors_->addItem(tr("Normals (noise)"), static_cast<int>(app::ErrorImage::normalNoise));
  errors_->addItem(tr("Curvature (noise)"), static_cast<int>(app::ErrorImage::kappaNoise));
  errors_->addItem(tr("Depth (rounding)"), static_cast<int>(app::ErrorImage::depth));
  errors_->addItem(tr("Normals (rounding)"), static_cast<int>(app::ErrorImage::normal));
  errors_->addItem(tr("Curvature (rounding)"), static_cast<int>(app::ErrorImage::kappa));
  errors_->addItem(tr("Light"), static_cast<int>(app::ErrorImage::light));
  // The longest entry does not make the panel wider.
  errors_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  errors_->setMinimumContentsLength(10);
  errors_->setAccessibleName(tr("Errors shown in the image"));
  errors_->setToolTip(
      tr("Overlays the bounds of this error on the final image as colours. Hatched pixels may exceed the "
         "limit entered above, or are uncertain"));
  setInk(note_, Ink::quiet);
  note_->hide();
  auto* const row = lineOf({new QLabel(tr("Error overlay"), this), {errors_, 1}});
  layOut(this, columnOf({row, note_}, 6), {});

  connect(errors_, &QComboBox::currentIndexChanged, this, [this] {
    Q_EMIT wantedChanged();
    paint();
  });
}

std::optional<app::ErrorImage> ErrorOverlayBox::chosen() const {
  const QVariant error = errors_->currentData();
  if (!error.isValid()) return std::nullopt;
  return static_cast<app::ErrorImage>(error.toInt());
}

void ErrorOverlayBox::choose(std::optional<app::ErrorImage> error) {
  errors_->setCurrentIndex(error ? errors_->findData(static_cast<int>(*error)) : 0);
}

QString ErrorOverlayBox::note() const {
  return note_->isHidden() ? QString() : note_->text();
}

void ErrorOverlayBox::setShown(const Shown& shown) {
  const bool same = shown.picture.cacheKey() == shown_.picture.cacheKey() && shown.errors == shown_.errors &&
                    shown.corner == shown_.corner && sameLimit(shown, shown_);
  shown_ = shown;
  if (!same) paint();
}

void ErrorOverlayBox::paint() {
  task_.reset();
  const std::optional<app::ErrorImage> error = chosen();
  const glm::ivec2 size(shown_.picture.width(), shown_.picture.height());
  const bool known = shown_.errors && shown_.errors->size == size && !shown_.picture.isNull();
  const bool noLight = error == app::ErrorImage::light && known && shown_.errors->light.empty();
  note_->setText(
      tr("This image has no baked light, or a surface is transparent; the look Global illumination bakes "
         "light"));
  note_->setVisible(noLight);
  if (!error || !known || noLight) return take({});
  app::OverlaySubject subject;
  subject.picture = [picture = shown_.picture] { return colorImageOf(picture); };
  subject.errors = shown_.errors;
  subject.request = {true, error, {}};
  if (shown_.limit) subject.request.limits = {*shown_.limit};
  subject.shortestEdgeMm = shown_.shortestEdgeMm;
  subject.corner = shown_.corner;
  subject.taken = shown_.legend;
  task_.watch(app::overlayTask(std::move(subject)), [this](auto& task) {
    if (task.error()) return take({});
    take(imageOf(task.value().image), task.value().legend);
  });
}

void ErrorOverlayBox::take(const QImage& image, const std::optional<render::Tile>& legend) {
  const bool nothing = image.isNull() && !isPainted_;
  isPainted_ = !image.isNull();
  if (!nothing) Q_EMIT painted(image, shown_.picture, legend);
}

}  // namespace isolux::ui
