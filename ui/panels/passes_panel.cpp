#include "ui/panels/passes_panel.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>

#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr int refreshMilliseconds = 200;
enum PassColumn { passNameColumn, stateColumn, timeColumn, memoryColumn, passColumns };

QString timeText(double milliseconds) {
  return milliseconds < 0.005 ? "0 ms" : numberText(milliseconds, milliseconds < 10.0 ? 2 : 3) + " ms";
}

QString sizeText(const render::FrameRequest& request) {
  QString text = QString("%1 × %2").arg(request.size.x).arg(request.size.y);
  if (request.supersampling > 1) text += QObject::tr(", %1 × %1 rays per pixel").arg(request.supersampling);
  return text;
}

bool anyRan(const render::FrameReport& report) {
  return std::any_of(report.passes.begin(), report.passes.end(),
                     [](const auto& pass) { return pass.state == render::PassState::ran; });
}

}  // namespace

PassesPanel::PassesPanel(QWidget* parent)
    : Panel(parent),
      heading_(wrappedLabel(tr("No image yet"), this)),
      summary_(wrappedLabel({}, this)),
      table_(new QTreeWidget(this)) {
  setInk(summary_, Ink::quiet);
  auto* copy = textButton(tr("Copy"), tr("Copy the table as text, for a document or a spreadsheet"), this);
  connect(copy, &QToolButton::clicked, this, [this] { QApplication::clipboard()->setText(text()); });

  table_->setHeaderLabels({tr("Pass"), tr("State"), tr("Time"), tr("Memory")});
  for (const PassColumn column : {timeColumn, memoryColumn})
    table_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  table_->setRootIsDecorated(false);
  table_->setItemsExpandable(false);
  table_->setIndentation(0);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setAccessibleName(tr("Passes of the last image"));
  QHeaderView* header = table_->header();
  header->setStretchLastSection(false);
  header->setSectionsClickable(false);
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(passNameColumn, QHeaderView::Stretch);

  auto* top = lineOf({{heading_, 1}});
  top->addWidget(copy, 0, Qt::AlignTop);
  layOut(this, columnOf({top, {table_, 1}, summary_}, 8), {12, 10, 12, 12});

  callOnce(timer_, refreshMilliseconds, this, &PassesPanel::refresh);
}

void PassesPanel::setReport(const render::FrameReport& report, const render::FrameRequest& request) {
  if (anyRan(report) || report_.passes.empty()) {
    report_ = report;
    request_ = request;
    shownAgain_ = 0;
    for (const render::PassReport& pass : report.passes)
      if (pass.state == render::PassState::ran) lastTimes_[pass.name] = pass.milliseconds;
  } else {
    ++shownAgain_;
  }
  if (isVisible() && !timer_.isActive()) timer_.start();
}

void PassesPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void PassesPanel::refresh() {
  if (!isVisible() || report_.passes.empty()) return;
  heading_->setText(QString("<b>%1</b><br>%2").arg(timeText(report_.milliseconds), sizeText(request_)));
  summary_->setText(summary());
  showPasses();
}

void PassesPanel::themeChanged() {
  table_->clear();
  refresh();
}

// A line for each pass and, below it, why it ran or did not.
void PassesPanel::showPasses() {
  const int count = static_cast<int>(report_.passes.size());
  while (table_->topLevelItemCount() > count) delete table_->takeTopLevelItem(count);
  QFont small = font();
  small.setPointSizeF(0.9 * small.pointSizeF());
  while (table_->topLevelItemCount() < count) {
    auto* item = new QTreeWidgetItem(table_);
    for (const PassColumn column : {timeColumn, memoryColumn})
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    item->setSizeHint(passNameColumn, {0, fontMetrics().height() + 8});
    auto* why = new QTreeWidgetItem(item);
    why->setFirstColumnSpanned(true);
    why->setForeground(passNameColumn, colours.quietText);
    why->setFont(passNameColumn, small);
    why->setSizeHint(passNameColumn, {0, fontMetrics().height() + 5});
    why->setTextAlignment(passNameColumn, Qt::AlignLeft | Qt::AlignTop);
    item->setExpanded(true);
  }
  write();
}

// The view hears of all lines at once: after each text on its own it would measure every row anew.
void PassesPanel::write() {
  const int count = table_->topLevelItemCount();
  QSignalBlocker quiet(table_->model());
  for (int row = 0; row < count; ++row) {
    const render::PassReport& pass = report_.passes[static_cast<std::size_t>(row)];
    const bool ran = pass.state == render::PassState::ran;
    QTreeWidgetItem* item = table_->topLevelItem(row);
    item->setText(passNameColumn, QString::fromStdString(pass.name));
    QFont bold = font();
    bold.setWeight(ran ? QFont::DemiBold : QFont::Normal);
    item->setFont(passNameColumn, bold);
    item->setText(stateColumn, translated(texts::passes, render::nameOf(pass.state)));
    item->setText(timeColumn, ran ? timeText(pass.milliseconds) : "–");
    item->setText(memoryColumn, pass.bytes > 0 ? bytesText(static_cast<double>(pass.bytes)) : "–");
    for (int column = 0; column < passColumns; ++column)
      item->setForeground(column, ran ? colours.text : colours.quietText);
    const auto last = lastTimes_.find(pass.name);
    item->setToolTip(timeColumn, ran || last == lastTimes_.end()
                                     ? QString()
                                     : tr("Last run took %1").arg(timeText(last->second)));
    QString reason = QString::fromStdString(pass.reason);
    if (pass.onProcessor && pass.state != render::PassState::skipped)
      reason = tr("on the CPU: %1").arg(reason);
    item->child(0)->setText(passNameColumn, reason);
    item->child(0)->setToolTip(passNameColumn, reason);
  }
  quiet.unblock();
  Q_EMIT table_->model()->dataChanged(table_->model()->index(0, 0),
                                      table_->model()->index(count - 1, passColumns - 1));
  table_->viewport()->update();
}

QString PassesPanel::summary() const {
  QStringList lines;
  lines += tr("Graphics memory: %1").arg(bytesText(static_cast<double>(report_.gpuBytes)));
  if (report_.blocksTotal > 0) {
    const double part =
        100.0 * static_cast<double>(report_.blocksActive) / static_cast<double>(report_.blocksTotal);
    lines += tr("Active blocks: %1 of %2 (%3 %)")
                 .arg(report_.blocksActive)
                 .arg(report_.blocksTotal)
                 .arg(numberText(part, 2));
  }
  if (!canvas_.why.isEmpty()) lines += tr("Display: %1").arg(describe(canvas_));
  if (shownAgain_ == 1) lines += tr("Redrawn once since, with all passes cached.");
  if (shownAgain_ > 1) lines += tr("Redrawn %1 times since, with all passes cached.").arg(shownAgain_);
  return lines.join('\n');
}

QString PassesPanel::text() const {
  QStringList lines{"pass\tstate\tms\tbytes\twhy"};
  for (const render::PassReport& pass : report_.passes)
    lines += QString("%1\t%2\t%3\t%4\t%5")
                 .arg(QString::fromStdString(pass.name), render::nameOf(pass.state))
                 .arg(numberText(pass.milliseconds, 4))
                 .arg(pass.bytes)
                 .arg(QString::fromStdString(pass.reason));
  lines += QString("picture\t%1\t%2\t%3\t")
               .arg(sizeText(request_), numberText(report_.milliseconds, 4))
               .arg(report_.gpuBytes);
  return lines.join('\n') + '\n';
}

}  // namespace isolux::ui
