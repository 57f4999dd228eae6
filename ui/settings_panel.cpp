#include "ui/settings_panel.h"

#include <algorithm>
#include <array>

#include <QFormLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/number_text.h"
#include "ui/setting_editor.h"

namespace isolux::ui {

namespace {
// The groups a user reaches for first; unknown groups follow in the order of the list.
constexpr std::array<const char*, 3> firstGroups{"look", "isosurface", "light"};
// Folded until asked for. `source` is not here at all: the volume panel edits it.
constexpr std::array<const char*, 3> foldedGroups{"camera", "memory", "picture"};

QString groupOf(const scene::Setting& setting) {
  return QString::fromStdString(setting.path).section('.', 0, 0);
}

std::vector<QString> groups() {
  std::vector<QString> result(firstGroups.begin(), firstGroups.end());
  for (const scene::Setting& setting : scene::settings()) {
    const QString group = groupOf(setting);
    if (group != "source" && std::find(result.begin(), result.end(), group) == result.end()) {
      result.push_back(group);
    }
  }
  return result;
}
}  // namespace

SettingsPanel::SettingsPanel(QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumWidth(310);
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 6, 6, 8);
  layout->setSpacing(2);
  for (const QString& group : groups()) {
    QWidget* box = addGroup(group, layout);
    auto* form = new QFormLayout(box);
    form->setContentsMargins(8, 2, 0, 8);
    form->setHorizontalSpacing(10);
    form->setVerticalSpacing(5);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    for (const scene::Setting& setting : scene::settings()) {
      if (groupOf(setting) != group) continue;
      auto* editor = new SettingEditor(setting, box);
      auto* label = new QLabel(wordsOf(QString::fromStdString(setting.path).section('.', 1)), box);
      label->setToolTip(editor->toolTip());
      label->setBuddy(editor->valueWidget());
      label->setFixedWidth(104);
      label->setWordWrap(true);
      form->addRow(label, editor);
      editors_.push_back(editor);
      connect(editor, &SettingEditor::edited, this, &SettingsPanel::edited);
      connect(editor, &SettingEditor::dragStarted, this, &SettingsPanel::dragStarted);
      connect(editor, &SettingEditor::dragEnded, this, &SettingsPanel::dragEnded);
      connect(editor, &SettingEditor::failed, this, &SettingsPanel::failed);
    }
  }
  layout->addStretch(1);
  setWidget(content);
}

QWidget* SettingsPanel::addGroup(const QString& group, QVBoxLayout* layout) {
  const bool folded = std::find(foldedGroups.begin(), foldedGroups.end(), group) != foldedGroups.end();
  auto* header = new QToolButton(this);
  header->setObjectName(group);
  header->setText(wordsOf(group));
  header->setCheckable(true);
  header->setChecked(!folded);
  header->setAutoRaise(true);
  header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
  header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QFont font = header->font();
  font.setWeight(QFont::DemiBold);
  header->setFont(font);
  auto* box = new QWidget(this);
  box->setVisible(!folded);
  connect(header, &QToolButton::toggled, box, &QWidget::setVisible);
  connect(header, &QToolButton::toggled, header,
          [header](bool open) { header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow); });
  header->setStyleSheet("QToolButton { border: 0; padding: 6px 4px; text-align: left; }");
  layout->addWidget(header);
  layout->addWidget(box);
  return box;
}

void SettingsPanel::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  for (SettingEditor* editor : editors_) editor->setScene(scene, resolved);
}

SettingEditor* SettingsPanel::editor(const QString& path) const {
  for (SettingEditor* editor : editors_) {
    if (QString::fromStdString(editor->setting().path) == path) return editor;
  }
  return nullptr;
}

void SettingsPanel::expand(const QString& group) {
  if (auto* header = findChild<QToolButton*>(group)) header->setChecked(true);
}

}  // namespace isolux::ui
