#include "ui/window/load_card.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "ui/editors/number_text.h"
#include "ui/window/style.h"

namespace isolux::ui {

LoadCard::LoadCard(QWidget* parent)
    : QFrame(parent),
      title_(new QLabel(this)),
      stage_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setObjectName("loadCard");
  setCursor(Qt::ArrowCursor);
  title_->setTextFormat(Qt::PlainText);
  setInk(stage_, Ink::quiet);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(8);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(16, 12, 12, 12);
  layout->setVerticalSpacing(5);
  layout->setHorizontalSpacing(14);
  layout->addWidget(title_, 0, 0);
  layout->addWidget(bar_, 1, 0);
  layout->addWidget(stage_, 2, 0);
  layout->addWidget(cancel_, 0, 1, 3, 1, Qt::AlignVCenter);
  layout->setColumnStretch(0, 1);
  parent->installEventFilter(this);
  delay_.setSingleShot(true);
  delay_.setInterval(150);
  connect(&delay_, &QTimer::timeout, this, [this] {
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
  bar_->setValue(0);
  left_.begin();
  place();
  if (!isVisible()) delay_.start();
}

void LoadCard::report(double fraction, const QString& stage) {
  bar_->setValue(static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * 1000.0)));
  const QString rest = left_.text(fraction);
  const QString doing = stage.isEmpty() ? QString(" ") : tr("%1 …").arg(wordsOf(stage));
  stage_->setText(rest.isEmpty() ? doing : tr("%1 %2").arg(doing, rest));
}

void LoadCard::end() {
  delay_.stop();
  hide();
}

bool LoadCard::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(object, event);
}

void LoadCard::place() {
  const QWidget* parent = parentWidget();
  const int width = std::min(420, std::max(200, parent->width() - 40));
  const int height = sizeHint().height();
  const int forTitle = width - 60 - cancel_->sizeHint().width();
  title_->setText(title_->fontMetrics().elidedText(tr("Opening %1").arg(name_), Qt::ElideMiddle, forTitle));
  setGeometry((parent->width() - width) / 2, parent->height() - height - 60, width, height);
}

}  // namespace isolux::ui
