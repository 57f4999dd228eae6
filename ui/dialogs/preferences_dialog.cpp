#include "ui/dialogs/preferences_dialog.h"

#include <map>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFrame>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QThread>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "ui/document/preferences.h"
#include "ui/document/privacy.h"
#include "ui/editors/value_widgets.h"
#include "ui/language/language.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/theme/style.h"
#include "ui/theme/theme.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

QString labelOf(const scene::SettingInfo& setting) {
  const std::map<std::string, QString> labels = {
      {"memory.gpu_budget_mb", QObject::tr("Graphics memory")},
      {"memory.layout", QObject::tr("Volume storage on the GPU")},
      {"gi.threads", QObject::tr("CPU threads for lighting")},
      {"picture.adaptive", QObject::tr("Lower resolution in motion")},
      {"picture.motion_target", QObject::tr("Frame time in motion")},
      {"picture.executor", QObject::tr("Ray casting device")},
      {"window.canvas", QObject::tr("Image display")}};
  const auto known = labels.find(setting.path);
  return known != labels.end() ? known->second : wordsOf(QString::fromStdString(setting.path));
}

// The window reads volumes whole: where voxels stay is for `isolux render`.
bool actsInTheWindow(const scene::HostSetting& setting) {
  return setting.path != "memory.voxels" && setting.path != "memory.ram_budget_mb";
}

QString describe(const scene::HostSetting& setting) {
  const nlohmann::json value = setting.defaultValue();
  const QString text = QString::fromStdString(value.is_string() ? value.get<std::string>() : value.dump());
  return translated(texts::settings, setting.meaning) + "\n\n" + QString::fromStdString(setting.path) + '\n' +
         QObject::tr("Default: %1").arg(text + ' ' + translated(texts::units, setting.unit));
}

}  // namespace

PreferencesDialog::PreferencesDialog(const scene::HostSettings& host, QWidget* parent)
    : QDialog(parent),
      host_(host),
      hideOnScreen_(new QCheckBox(tr("Hide on the &screen"), this)),
      hideInSaved_(new QCheckBox(tr("Hide in sa&ved files: images, measurements, recordings"), this)),
      theme_(new QComboBox(this)),
      scale_(new IntegerSpinBox(this)),
      language_(new QComboBox(this)) {
  setWindowTitle(tr("Preferences"));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(14);
  grid->setVerticalSpacing(9);
  for (const scene::HostSetting& setting : scene::hostSettings()) {
    if (!actsInTheWindow(setting)) continue;
    const int line = static_cast<int>(rows_.size());
    Row row{&setting, nullptr, makeValueWidget(setting, this), nullptr};
    row.label = addRow(grid, line, labelOf(setting), row.value, describe(setting));
    nameValueWidget(row.value, labelOf(setting));
    if (setting.mayBeAutomatic) {
      row.automatic = new QCheckBox(tr("auto"), this);
      grid->addWidget(row.automatic, line, 2);
    }
    rows_.push_back(row);
    connect(row.value, &ValueWidget::changed, this, [this, row] { set(row, row.value->value()); });
    if (row.automatic)
      connect(row.automatic, &QCheckBox::clicked, this, [this, row](bool automatic) {
        set(row, automatic ? nlohmann::json("auto") : row.value->value());
      });
    showRow(row);
  }
  addLanguage(grid);
  grid->setColumnStretch(1, 1);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::RestoreDefaults | QDialogButtonBox::Close, this);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
          &PreferencesDialog::restoreDefaults);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* line = new QFrame(this);
  line->setFrameShape(QFrame::HLine);
  auto* note = wrappedLabel(tr("Stored on this computer only, not in sessions or recordings."), this);
  layOut(this, columnOf({makeAppearance(), line, grid, note, makePrivacy(), Cell::room(), buttons}, 14),
         {18, 18, 18, 14});
  setMinimumWidth(440);
}

// Theme and scale, kept at once.
QGridLayout* PreferencesDialog::makeAppearance() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(14);
  grid->setVerticalSpacing(9);
  theme_->addItems({tr("Dark"), tr("Light"), tr("System default")});  // as Theme
  addRow(grid, 0, tr("Theme"), theme_, tr("The background of the image is a setting of the scene."));
  const int scaleOfThisRun = savedScale();
  scale_->setRange(smallestScale, largestScale);
  scale_->setSingleStep(25);
  scale_->setSuffix(" %");
  addRow(grid, 1, tr("Text and control size"), scale_, tr("Multiplies the scaling of the screen."));
  auto* later = new QLabel(tr("Takes effect after a restart."), this);
  grid->addWidget(later, 2, 1);
  grid->setColumnStretch(1, 1);
  setInk(later, Ink::quiet);
  later->hide();
  theme_->setCurrentIndex(static_cast<int>(theme()));
  scale_->setValue(scaleOfThisRun);
  connect(theme_, &QComboBox::currentIndexChanged, this, [](int row) {
    keepTheme(static_cast<Theme>(row));
    applyTheme(static_cast<Theme>(row));
  });
  connect(scale_, &QSpinBox::valueChanged, this, [later, scaleOfThisRun](int percent) {
    keepScale(percent);
    later->setVisible(percent != scaleOfThisRun);
  });
  return grid;
}

// Kept at once.
QGroupBox* PreferencesDialog::makePrivacy() {
  auto* box = new QGroupBox(tr("Patient’s name, ID and birth date"), this);
  hideOnScreen_->setToolTip(tr("Applies to titles, the Volume panel, the DICOM browser and recent files"));
  hideInSaved_->setToolTip(
      tr("Applies to sessions embedded in images, exported measurements, recordings and proposed file names. "
         "Session files always name the files that they open."));
  const Privacy privacy = savedPrivacy();
  hideOnScreen_->setChecked(privacy.hideOnScreen);
  hideInSaved_->setChecked(privacy.hideInSaved);
  layOut(box, columnOf({hideOnScreen_, hideInSaved_}));
  for (const QCheckBox* hide : {hideOnScreen_, hideInSaved_})
    connect(hide, &QCheckBox::toggled, this, [this] {
      keepPrivacy({hideOnScreen_->isChecked(), hideInSaved_->isChecked()});
      Q_EMIT privacyChanged();
    });
  return box;
}

void PreferencesDialog::addLanguage(QGridLayout* grid) {
  // Each in itself, so that who has chosen a foreign one finds back.
  language_->addItem(tr("System default"), static_cast<int>(Language::system));
  language_->addItem("English", static_cast<int>(Language::english));
  language_->addItem("Deutsch", static_cast<int>(Language::german));
  language_->setCurrentIndex(language_->findData(static_cast<int>(savedLanguage())));
  const QString tip = tr("Language of the window; takes effect after a restart.");
  auto* hint = wrappedLabel(tip, this);
  hint->hide();
  const int line = grid->rowCount();
  addRow(grid, line, tr("Language"), language_, tip);
  grid->addWidget(hint, line + 1, 0, 1, 2);
  connect(language_, &QComboBox::currentIndexChanged, this, [this, hint] {
    keepLanguage(static_cast<Language>(language_->currentData().toInt()));
    hint->show();
  });
}

void PreferencesDialog::set(const Row& row, const nlohmann::json& value) {
  const scene::HostSettings before = host_;
  try {
    row.setting->set(host_, value);
  } catch (const base::Error&) {  // out of range: the editor shows again what holds
  }
  for (const Row& other : rows_) showRow(other);
  if (!(host_ == before)) Q_EMIT changed(host_);
}

void PreferencesDialog::showRow(const Row& row) {
  const nlohmann::json value = row.setting->get(host_);
  const bool automatic = value.is_string() && row.automatic;
  const nlohmann::json cores = QThread::idealThreadCount();  // threads alone are ever automatic
  row.value->showValue(automatic ? cores : value);
  const bool acts = row.setting->path != "picture.motion_target" || host_.adaptive;
  row.value->setEnabled(!automatic && acts);
  row.label->setEnabled(acts);
  if (!row.automatic) return;
  const QSignalBlocker block(row.automatic);
  row.automatic->setChecked(automatic);
}

void PreferencesDialog::restoreDefaults() {
  theme_->setCurrentIndex(static_cast<int>(Theme::dark));
  scale_->setValue(100);
  language_->setCurrentIndex(0);
  if (host_ == scene::HostSettings{}) return;
  host_ = {};
  for (const Row& row : rows_) showRow(row);
  Q_EMIT changed(host_);
}

}  // namespace isolux::ui
