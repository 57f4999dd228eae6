#include "ui/window/load_card.h"

#include <algorithm>

#include <QEvent>
#include <QGridLayout>
#include <QPixmap>
#include <QProgressBar>
#include <QPushButton>

#include "ui/document/picture_pixels.h"
#include "ui/language/number_text.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {
constexpr int margin = 16, pictureHeight = 230;
}  // namespace

LoadCard::LoadCard(QWidget* parent)
    : QFrame(parent),
      picture_(new QLabel(this)),
      caption_(new QLabel(this)),
      title_(new QLabel(this)),
      stage_(new QLabel(this)),
      bar_(thinBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName("loadCard");
  setCursor(Qt::ArrowCursor);
  title_->setTextFormat(Qt::PlainText);
  picture_->setObjectName("firstLook");
  for (QLabel* const label : {stage_, caption_}) setInk(label, Ink::quiet);
  dropLook();
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(margin, 12, 12, 12);
  layout->setVerticalSpacing(5);
  layout->setHorizontalSpacing(14);
  layout->addWidget(picture_, 0, 0, 1, 2, Qt::AlignHCenter);
  layout->addWidget(caption_, 1, 0, 1, 2);
  layout->addWidget(title_, 2, 0);
  layout->addWidget(bar_, 3, 0);
  layout->addWidget(stage_, 4, 0);
  layout->addWidget(cancel_, 2, 1, 3, 1, Qt::AlignVCenter);
  layout->setColumnStretch(0, 1);
  parent->installEventFilter(this);
  callOnce(delay_, 150, this, [this] {
    place();
    show();
    raise();
  });
  connect(cancel_, &QPushButton::clicked, this, &LoadCard::cancelled);
  hide();
}

void LoadCard::begin(const QString& name) {
  name_ = name;
  stage_->setText(" ");
  showFraction(bar_, 0.0);
  left_.begin();
  dropLook();
  place();
  if (!isVisible()) delay_.start();
}

void LoadCard::report(double fraction, const QString& stage) {
  showFraction(bar_, fraction);
  const QString rest = left_.text(fraction);
  const QString doing = stage.isEmpty() ? QString(" ") : tr("%1…").arg(wordsOf(stage));
  stage_->setText(rest.isEmpty() ? doing : tr("%1 %2").arg(doing, rest));
}

void LoadCard::end() {
  delay_.stop();
  dropLook();
  hide();
}

void LoadCard::lookAt(const scene::Scene& scene) {
  dropLook();
  const double ratio = devicePixelRatioF();
  app::VolumePreviewSubject subject;
  subject.scene = scene;
  subject.size = glm::ivec2(glm::round(ratio * glm::dvec2(cardWidth() - 2 * margin, pictureHeight)));
  subject.pixelRatio = ratio;
  subject.least = leastBytes_;
  look_.watch(app::volumePreviewTask(std::move(subject)), [this](auto& task) {
    // Whoever loads the volume says what is wrong with it.
    if (!task.error() && task.value()) showPreview(*task.value());
  });
}

void LoadCard::showPreview(const app::DrawnVolumePreview& preview) {
  QPixmap picture = QPixmap::fromImage(imageOf(preview.picture));
  picture.setDevicePixelRatio(devicePixelRatioF());
  picture_->setPixmap(picture);
  const glm::ivec3 step = preview.step;
  const QString caption = preview.fromIndex ? tr("Preview from the index: blocks of %1 × %2 × %3 voxels")
                                            : tr("Preview: one voxel of each %1 × %2 × %3");
  caption_->setText(caption.arg(step.x).arg(step.y).arg(step.z));
  picture_->show();
  caption_->show();
  place();
}

void LoadCard::dropLook() {
  look_.reset();
  picture_->hide();
  picture_->setPixmap({});
  caption_->hide();
}

int LoadCard::cardWidth() const {
  return std::min(420, std::max(200, parentWidget()->width() - 40));
}

bool LoadCard::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(object, event);
}

void LoadCard::place() {
  const QWidget* parent = parentWidget();
  const int width = cardWidth();
  const int height = sizeHint().height();
  const int forTitle = width - 60 - cancel_->sizeHint().width();
  title_->setText(title_->fontMetrics().elidedText(tr("Opening %1").arg(name_), Qt::ElideMiddle, forTitle));
  setGeometry((parent->width() - width) / 2, parent->height() - height - 60, width, height);
}

}  // namespace isolux::ui
