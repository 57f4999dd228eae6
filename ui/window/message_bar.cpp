#include "ui/window/message_bar.h"

#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "ui/document/background_task.h"
#include "ui/theme/icons.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      symbol_(new QLabel(this)),
      label_(new WrappedText(this)),
      layout_(new QHBoxLayout(this)) {
  setObjectName("messageBar");
  setAttribute(Qt::WA_NoMousePropagation);  // a press here is no drag of the picture
  setCursor(Qt::ArrowCursor);
  auto* close = new QToolButton(this);
  close->setIcon(icon("close"));
  close->setAutoRaise(true);
  nameAndTip(close, tr("Close this message"));
  layout_->setContentsMargins(12, 7, 8, 7);
  layout_->setSpacing(10);
  layout_->addWidget(symbol_);
  layout_->addWidget(label_, 1, Qt::AlignVCenter);
  layout_->addWidget(close);
  callOnce(timer_, 8000, this, &MessageBar::clear);

  connect(close, &QToolButton::clicked, this, &MessageBar::close);
  parent->installEventFilter(this);
  QFrame::hide();
}

void MessageBar::show(Kind kind, const QString& text, std::vector<Answer> answers) {
  Message message{kind, text, std::move(answers)};
  if (kind == Kind::question) question_ = message;
  if (kind == Kind::warning) warning_ = message;
  present(std::move(message));
}

void MessageBar::present(Message message) {
  shown_ = std::move(message);
  label_->setText(filter_ ? filter_(shown_.text) : shown_.text);
  makeButtons();
  dress();
  if (shown_.kind == Kind::note) {
    timer_.start();
  } else {
    timer_.stop();
  }
  place();
  QFrame::show();
  raise();
}

// In the colours of the theme (ui/theme/style.h).
void MessageBar::dress() {
  const bool error = shown_.kind == Kind::error, warning = shown_.kind == Kind::warning;
  const QColor colour = error ? colours.error : warning ? colours.warning : colours.accent;
  symbol_->setPixmap(iconPixmap(error || warning ? "error" : "info", 18, colour, devicePixelRatioF()));
  const QString level = error ? "error" : warning ? "warning" : "note";
  if (property("level").toString() == level) return;
  setProperty("level", level);
  style()->unpolish(this);
  style()->polish(this);
}

void MessageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) dress();
}

void MessageBar::makeButtons() {
  for (QPushButton* button : std::exchange(buttons_, {})) button->deleteLater();
  for (const Answer& answer : shown_.answers) {
    auto* button = new QPushButton(answer.text, this);
    button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the picture
    layout_->insertWidget(layout_->count() - 1, button);
    button->show();  // at once: the height of the bar depends on it
    connect(button, &QPushButton::clicked, this, [this, chosen = answer.chosen] {
      close();
      if (chosen) chosen();
    });
    buttons_.push_back(button);
  }
}

void MessageBar::clear() {
  timer_.stop();
  if (const std::optional<Message>& waiting = question_ ? question_ : warning_) {
    if (shown_.kind != waiting->kind) present(*waiting);
    return;
  }
  shown_ = {};
  label_->setText({});
  makeButtons();
  hide();
}

void MessageBar::withdraw(Kind kind) {
  if (kind == Kind::question) question_.reset();
  if (kind == Kind::warning) warning_.reset();
  if (shown_.kind == kind) clear();
}

void MessageBar::place() {
  const int width = parentWidget()->width();
  layout_->activate();
  const int height = layout_->totalHeightForWidth(width);
  setGeometry(0, 0, width, height);
  Q_EMIT heightTaken(height);
}

bool MessageBar::eventFilter(QObject* parent, QEvent* event) {
  if (event->type() == QEvent::Resize && !isHidden()) place();
  return QFrame::eventFilter(parent, event);
}

void MessageBar::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  if (isHidden()) Q_EMIT heightTaken(0);
}

}  // namespace isolux::ui
