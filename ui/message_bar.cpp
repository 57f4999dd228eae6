#include "ui/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/icons.h"
#include "ui/style.h"

namespace isolux::ui {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), symbol_(new QLabel(this)), label_(new QLabel(this)) {
  setObjectName("messageBar");
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label_->setTextFormat(Qt::PlainText);
  auto* close = new QToolButton(this);
  close->setIcon(icon("close"));
  close->setAutoRaise(true);
  close->setToolTip("Close this message");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 7, 8, 7);
  layout->setSpacing(10);
  layout->addWidget(symbol_);
  layout->addWidget(label_, 1);
  layout->addWidget(close);
  timer_.setSingleShot(true);
  timer_.setInterval(8000);
  connect(&timer_, &QTimer::timeout, this, &MessageBar::clear);
  connect(close, &QToolButton::clicked, this, &MessageBar::clear);
  QFrame::hide();
}

void MessageBar::show(Kind kind, const QString& text) {
  kind_ = kind;
  label_->setText(text);
  const bool error = kind == Kind::error;
  const QColor colour = error ? colours::error : colours::accent;
  symbol_->setPixmap(iconPixmap(error ? "error" : "info", 18, colour, devicePixelRatioF()));
  setStyleSheet(QString("#messageBar { background: %1; border: 0; border-left: 4px solid %2; "
                        "border-bottom: 1px solid %3; }")
                    .arg(error ? "#3a2829" : "#26323d", colour.name(), colours::border.name()));
  if (error) {
    timer_.stop();
  } else {
    timer_.start();
  }
  QFrame::show();
}

void MessageBar::clear() {
  timer_.stop();
  label_->clear();
  hide();
}

QString MessageBar::text() const {
  return label_->text();
}

}  // namespace isolux::ui
