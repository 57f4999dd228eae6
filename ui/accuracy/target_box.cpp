#include "ui/accuracy/target_box.h"

#include <algorithm>
#include <iterator>

#include <QComboBox>
#include <QGridLayout>
#include <QPushButton>

#include "scene/rules/needs.h"
#include "ui/accuracy/accuracy_text.h"
#include "ui/theme/style.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr int narrowestNumber = 48, shortestUnit = 13;  // pixels; characters
constexpr double mostAtFirst = 0.01, millisecondsAtFirst = 100.0;

bool sameQuestion(const app::TargetSubject& a, const app::TargetSubject& b) {
  return a.volume == b.volume && a.given == b.given && a.picture.size == b.picture.size &&
         a.picture.pixelRatio == b.picture.pixelRatio && a.host == b.host;
}

}  // namespace

TargetBox::TargetBox(QWidget* parent)
    : QWidget(parent),
      error_(new QRadioButton(tr("Error at most"), this)),
      time_(new QRadioButton(tr("Time at most"), this)),
      most_(new NumberSpinBox(this)),
      milliseconds_(new NumberSpinBox(this)),
      unit_(new QComboBox(this)),
      find_(new QPushButton(this)),
      apply_(new QPushButton(tr("Apply"), this)),
      text_(wrappedLabel({}, this)) {
  makeRows();
  for (NumberSpinBox* box : {most_, milliseconds_}) box->setOwnUndo();
  connect(most_, &QDoubleSpinBox::valueChanged, this, [this] { error_->setChecked(true); });
  connect(milliseconds_, &QDoubleSpinBox::valueChanged, this, [this] { time_->setChecked(true); });
  connect(unit_, &QComboBox::activated, this, [this] { error_->setChecked(true); });
  connect(find_, &QPushButton::clicked, this, [this] { task_ ? drop() : find(); });
  connect(apply_, &QPushButton::clicked, this, &TargetBox::apply);
  connect(most_, &QDoubleSpinBox::valueChanged, this, &TargetBox::limitChanged);
  connect(unit_, &QComboBox::currentIndexChanged, this, &TargetBox::limitChanged);
  connect(error_, &QRadioButton::toggled, this, &TargetBox::limitChanged);
  showState();
}

void TargetBox::makeRows() {
  error_->setChecked(true);
  most_->setAccessibleName(tr("Error at most"));
  milliseconds_->setAccessibleName(tr("Maximum time, milliseconds"));
  unit_->setAccessibleName(tr("Kind of error"));
  for (const app::Quantity each : app::kAllQuantities) unit_->addItem(unitTextOf(each));
  most_->setValue(mostAtFirst);
  milliseconds_->setValue(millisecondsAtFirst);
  for (NumberSpinBox* const box : {most_, milliseconds_}) {
    box->setMinimum(0.0);
    box->setMinimumWidth(narrowestNumber);
  }
  // The row is as wide as the panel has room, not the panel as wide as the longest unit.
  unit_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  unit_->setMinimumContentsLength(shortestUnit);
  apply_->setToolTip(tr("Apply these settings as one undo step"));
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* rows = new QGridLayout;
  rows->setHorizontalSpacing(8);
  rows->setVerticalSpacing(6);
  rows->setColumnStretch(1, 1);
  rows->setColumnStretch(2, 2);
  rows->addWidget(error_, 0, 0);
  rows->addWidget(most_, 0, 1);
  rows->addWidget(unit_, 0, 2);
  rows->addWidget(time_, 1, 0);
  rows->addWidget(milliseconds_, 1, 1);
  rows->addWidget(new QLabel(tr("ms per image"), this), 1, 2);
  layOut(this, columnOf({rows, lineOf({find_, apply_, Cell::room()}), text_}, 8), {});
}

void TargetBox::setSubject(const app::TargetSubject& subject) {
  const bool same = sameQuestion(subject, subject_);
  subject_ = subject;
  if (!same) drop();
  showState();
}

void TargetBox::drop() {
  const bool searched = searching();
  task_.reset();
  answer_.reset();
  said_.clear();
  showState();
  if (searched) Q_EMIT searchingChanged();
}

void TargetBox::askError(app::Quantity quantity, double most) {
  error_->setChecked(true);
  unit_->setCurrentIndex(static_cast<int>(app::indexOf(quantity)));
  most_->setValue(most);
}

void TargetBox::askTime(double milliseconds) {
  milliseconds_->setValue(milliseconds);
  time_->setChecked(true);
}

app::Quantity TargetBox::quantity() const {
  return app::kAllQuantities[static_cast<std::size_t>(std::max(unit_->currentIndex(), 0))];
}

std::optional<app::Limit> TargetBox::limit() const {
  if (asksTime()) return std::nullopt;
  return app::Limit{quantity(), most_->value() * unitOf(quantity())};
}

QString TargetBox::questionName() const {
  return asksTime() ? tr("Keep %1 ms").arg(milliseconds_->text())
                    : tr("Keep %1 %2").arg(most_->text(), unit_->currentText());
}

// The search

void TargetBox::find() {
  drop();
  if (subject_.given.surfaces.front().clipped && scene::cutsSurfaces(subject_.given)) {
    said_ = tr("Errors are known only for an uncut isosurface: remove the cuts or exclude it from them");
    return showState();
  }
  app::TargetSubject question = subject_;
  question.limits.clear();
  question.milliseconds = milliseconds_->value();
  if (const std::optional<app::Limit> asked = limit()) question.limits = {*asked};
  const bool mayBeNone = !asksTime() && quantity() == app::Quantity::missed;
  if (!mayBeNone && !((asksTime() ? question.milliseconds : question.limits.front().most) > 0.0)) {
    said_ = tr("No settings achieve 0: enter a larger number");
    return showState();
  }
  task_.watch(
      app::targetTask(std::move(question)), [this](auto& task) { take(task); }, [this] { showState(); });
  showState();
  Q_EMIT searchingChanged();
}

void TargetBox::take(app::TargetTask& task) {
  if (task.error()) {
    said_ = refusalText(*task.error());
  } else if (const auto& found = task.value(); !found) {
    said_ = nothingSeenText();
  } else if (found->measured.empty() || (!asksTime() && found->asked == 0)) {
    said_ = ignoredText(quantity());
  } else {
    answer_ = found;
    said_ = answerText(*answer_);
  }
  showState();
  Q_EMIT searchingChanged();
}

void TargetBox::apply() {
  if (!answer_) return;
  const app::Candidate& chosen = answer_->measured[answer_->chosen].candidate;
  const Edit edit{app::applied(chosen, subject_.given), questionName(), {}, false};
  if (!(edit.scene == subject_.given)) Q_EMIT edited(edit);
}

// What is shown

void TargetBox::showState() {
  find_->setText(task_ ? tr("Stop") : tr("Find settings"));
  find_->setEnabled(task_ || (subject_.volume && subject_.picture.size.x > 0));
  for (QWidget* const control : std::initializer_list<QWidget*>{error_, time_, most_, milliseconds_, unit_})
    control->setEnabled(!task_);
  apply_->setEnabled(answer_ && !answer_->measured[answer_->chosen].candidate.assignments.empty());
  const QString text =
      task_ ? tr("Searching… %1 %").arg(qRound(100.0 * task_->progress().fraction())) : said_;
  if (text_->text() != text) text_->setText(text);
  text_->setVisible(!text.isEmpty());
}

}  // namespace isolux::ui
