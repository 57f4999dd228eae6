#include "ui/editors/file_widget.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QSettings>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include "ui/theme/icons.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {
constexpr auto folderKey = "lightProbeFolder";
}

bool isLightProbe(const QString& file) {
  const QString suffix = QFileInfo(file).suffix().toLower();
  return suffix == "hdr" || suffix == "exr";
}

FileWidget::FileWidget(QWidget* parent)
    : ValueWidget(parent), line_(new QLineEdit(this)), choose_(new QToolButton(this)) {
  layOut(this, lineOf({{line_, 1}, choose_}, 4), {});
  line_->setPlaceholderText(tr("none"));
  line_->setMinimumWidth(60);
  choose_->setIcon(icon("open"));
  choose_->setIconSize({16, 16});
  nameAndTip(choose_, tr("Choose a file"));
  setFocusProxy(line_);
  connect(line_, &QLineEdit::editingFinished, this, [this] {
    if (!line_->isModified()) return;
    line_->setModified(false);
    Q_EMIT changed(false);
  });
  connect(choose_, &QToolButton::clicked, this, &FileWidget::choose);
}

void FileWidget::choose() {
  const QString start = line_->text().isEmpty() ? QSettings().value(folderKey).toString() : line_->text();
  const QString file = QFileDialog::getOpenFileName(this, tr("Choose an environment map"), start,
                                                    tr("Environment maps (*.hdr *.exr);;Images (*.hdr *.exr "
                                                       "*.png *.jpg *.jpeg *.tif *.tiff);;All files (*)"));
  if (file.isEmpty()) return;
  QSettings().setValue(folderKey, QFileInfo(file).absolutePath());
  line_->setText(file);
  line_->setModified(false);
  Q_EMIT changed(false);
}

void FileWidget::showValue(const nlohmann::json& value) {
  const QString file = QString::fromStdString(value.get<std::string>());
  line_->setText(file);
  line_->setToolTip(file);
}

nlohmann::json FileWidget::value() const {
  return line_->text().trimmed().toStdString();
}

}  // namespace isolux::ui
