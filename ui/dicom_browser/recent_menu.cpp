#include "ui/dicom_browser/recent_menu.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QToolButton>

#include "ui/document/privacy.h"
#include "ui/theme/style.h"

namespace isolux::ui {

namespace {

constexpr QSize menuPicture(80, 50), rowPicture(160, 100);
constexpr int mostPictures = 5, widestName = 420;  // pixels

// Menus with pictures larger than icons are.
class PictureMenuStyle : public QProxyStyle {
 public:
  PictureMenuStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    if (metric == PM_SmallIconSize) return menuPicture.width();
    return QProxyStyle::pixelMetric(metric, option, widget);
  }
};

// In the middle of a plate of that size; without a picture an empty plate.
QPixmap plateOf(const RecentFile& file, QSize size, double ratio) {
  QPixmap plate(size * ratio);
  plate.fill(colours.base);
  const QImage picture(recentPicture(file));
  QPainter painter(&plate);
  if (!picture.isNull()) {
    const QImage scaled =
        picture.scaled(plate.size(), Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    painter.drawImage((plate.width() - scaled.width()) / 2, (plate.height() - scaled.height()) / 2, scaled);
  }
  painter.setPen(colours.border);
  painter.drawRect(0, 0, plate.width() - 1, plate.height() - 1);
  painter.end();
  plate.setDevicePixelRatio(ratio);
  return plate;
}

}  // namespace

QString shownName(const RecentFile& file) {
  const bool builtIn = file.path.startsWith("phantom:");
  const QString plain = !file.name.isEmpty() ? file.name
                        : builtIn            ? file.path
                                             : QFileInfo(file.path).fileName();
  if (!savedPrivacy().hideOnScreen || builtIn) return plain;
  return file.hidden.isEmpty() ? QObject::tr("anonymous") : file.hidden;
}

RecentMenu::RecentMenu(const QString& title, QWidget* parent) : QMenu(title, parent) {
  auto* style = new PictureMenuStyle;
  style->setParent(this);
  setStyle(style);
  setToolTipsVisible(true);
  connect(this, &QMenu::aboutToShow, this, &RecentMenu::fill);
}

void RecentMenu::fill() {
  clear();
  const QList<RecentFile> files = recentEntries();
  for (const RecentFile& file : files) {
    QString shown = fontMetrics().elidedText(shownName(file), Qt::ElideMiddle, widestName);
    QAction* const action = addAction(plateOf(file, menuPicture, devicePixelRatioF()),
                                      shown.replace('&', "&&"), this, [this, file] { Q_EMIT chosen(file); });
    action->setIconVisibleInMenu(true);
    if (!savedPrivacy().hideOnScreen) action->setToolTip(file.path);
  }
  if (files.isEmpty()) {
    addAction(tr("No recent files"))->setEnabled(false);
    return;
  }
  addSeparator();
  addAction(tr("Clear this list"), this, &clearRecentFiles);
}

RecentPictures::RecentPictures(QWidget* parent) : QFrame(parent), row_(new QHBoxLayout(this)) {
  setObjectName("recentPictures");
  setCursor(Qt::ArrowCursor);
  setAccessibleName(tr("Recently opened"));
  row_->setSpacing(10);
  parent->installEventFilter(this);
  hide();
}

void RecentPictures::fill() {
  while (QLayoutItem* item = row_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  const QList<RecentFile> files = recentEntries();
  for (const RecentFile& file : files.mid(0, mostPictures)) {
    auto* button = new QToolButton(this);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setAutoRaise(true);
    button->setIconSize(rowPicture);
    button->setIcon(plateOf(file, rowPicture, devicePixelRatioF()));
    button->setText(fontMetrics().elidedText(shownName(file), Qt::ElideMiddle, rowPicture.width()));
    button->setAccessibleName(shownName(file));
    if (!savedPrivacy().hideOnScreen) button->setToolTip(file.path);
    connect(button, &QToolButton::clicked, this, [this, file] { Q_EMIT chosen(file); });
    row_->addWidget(button);
  }
  setVisible(!files.isEmpty());
  place();
}

bool RecentPictures::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(object, event);
}

void RecentPictures::place() {
  const QWidget* parent = parentWidget();
  const QSize wanted = row_->sizeHint().boundedTo(parent->size());
  setGeometry((parent->width() - wanted.width()) / 2, parent->height() - wanted.height() - 24, wanted.width(),
              wanted.height());
}

}  // namespace isolux::ui
