#include "ui/panels/settings_panel.h"

#include <algorithm>

#include <QBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include "scene/rules/relevance.h"
#include "ui/document/environment_edit.h"
#include "ui/editors/environment_preview.h"
#include "ui/editors/light_chooser.h"
#include "ui/editors/setting_editor.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/theme/icons.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr int labelWidth = 104, indentation = 10;
constexpr int settleMilliseconds = 600;  // after the last turn of a wheel

QString wordsToSearch(const scene::Setting& setting, const QString& label, const QString& group) {
  QString words = group + ' ' + label + ' ' + QString::fromStdString(setting.path) + ' ' +
                  QString::fromStdString(setting.meaning) + ' ' +
                  translated(texts::settings, setting.meaning) + ' ' + QString::fromStdString(setting.unit);
  for (const std::string& choice : setting.choices)
    words += ' ' + QString::fromStdString(choice) + ' ' + wordsOf(QString::fromStdString(choice));
  words.replace('_', ' ');
  return words.toLower().replace("colour", "color");
}

// The row is for who searches for it.
bool shownByThumbnails(const scene::Setting& setting) {
  return setting.path == "light.environment.builtin";
}

bool turnsEnvironment(const scene::Setting& setting) {
  return setting.path == "light.environment.azimuth" || setting.path == "light.environment.elevation";
}

struct ListWords {
  QString add, remove, most;
};

ListWords wordsFor(const scene::SceneList& list) {
  if (list.path == "lamps")
    return {QObject::tr("Add light"), QObject::tr("Remove light"),
            QObject::tr("At most %1 lights are possible")};
  return {QObject::tr("Add isosurface"), QObject::tr("Remove isosurface"),
          QObject::tr("At most %1 isosurfaces are possible")};
}

// Why no item of the list has an effect; empty: they act.
QString whyUseless(const scene::SceneList& list, const scene::Scene& scene) {
  return translated(texts::reasons, scene::whyInactive(list.path + ".#.shown", scene));
}

QToolButton* makeHeader(const PanelGroup& plan, QWidget* parent) {
  auto* header = new QToolButton(parent);
  header->setObjectName(plan.title);
  header->setText(QObject::tr(plan.title.toUtf8()));
  header->setCheckable(true);
  header->setAutoRaise(true);
  header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  makeBold(header);
  header->setStyleSheet("QToolButton { border: 0; padding: 6px 4px; text-align: left; }");
  return header;
}

}  // namespace

SettingsPanel::SettingsPanel(QWidget* parent)
    : Panel(parent),
      search_(new QLineEdit(this)),
      scroll_(new QScrollArea(this)),
      nothing_(wrappedLabel(
          tr("No matching setting.\nMemory, threads and speed in motion are in Edit > Preferences."), this)),
      lights_(new LightChooser(this)),
      environment_(new EnvironmentPreview(this)) {
  setMinimumWidth(340);
  search_->setPlaceholderText(tr("Find a setting"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Find a setting"));
  scroll_->setAccessibleName(tr("Settings of the scene"));
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  nothing_->setAlignment(Qt::AlignHCenter);
  nothing_->setContentsMargins(0, 24, 0, 0);
  setInk(nothing_, Ink::quiet);
  nothing_->hide();

  auto* content = new QWidget(scroll_);
  auto* groups = columnOf({nothing_}, 2);
  layOut(content, groups, {8, 2, 6, 8});
  for (const PanelGroup& plan : panelGroups()) addGroup(plan, groups);
  groups->addStretch(1);
  scroll_->setWidget(content);

  auto* searchBox = columnOf({search_});
  searchBox->setContentsMargins(12, 8, 12, 6);
  layOut(this, columnOf({searchBox, {scroll_, 1}}, 0), {});
  callOnce(settle_, settleMilliseconds, this, &SettingsPanel::showRows);

  connect(search_, &QLineEdit::textChanged, this, &SettingsPanel::search);
  connect(lights_, &LightChooser::edited, this, &SettingsPanel::edited);
  connect(environment_, &EnvironmentPreview::edited, this, &SettingsPanel::edited);
  connect(environment_, &EnvironmentPreview::dragStarted, this, &SettingsPanel::dragStarted);
  connect(environment_, &EnvironmentPreview::dragEnded, this, &SettingsPanel::dragEnded);
  connect(environment_, &EnvironmentPreview::failed, this, &SettingsPanel::failed);
}

void SettingsPanel::addGroup(const PanelGroup& plan, QBoxLayout* layout) {
  auto* box = new QWidget(this);
  Group group{makeHeader(plan, this), box, {}, plan.open};
  layout->addWidget(group.header);
  layout->addWidget(box);
  // Not a QFormLayout: rows of one that are hidden and shown again in another order get lost.
  auto* rows = columnOf({}, 5);
  layOut(box, rows, {8, 2, 0, 8});
  if (plan.title == environmentGroup) {
    rows->addWidget(lights_);
    rows->addWidget(environment_);
  }
  for (const scene::Setting& setting : plan.settings) group.rows.push_back(addRow(setting, group));
  group.list = plan.list;
  if (group.list != nullptr) {
    addItemRows(group);
    group.addItem = new QPushButton(wordsFor(*group.list).add, box);
    rows->addWidget(group.addItem, 0, Qt::AlignLeft);
  }
  groups_.push_back(std::move(group));
  const std::size_t index = groups_.size() - 1;
  connect(groups_.back().header, &QToolButton::clicked, this, [this, index](bool open) {
    groups_[index].open = open;
    showGroup(groups_[index]);
  });
  if (plan.list == nullptr) return;
  connect(groups_.back().addItem, &QPushButton::clicked, this, [this, list = plan.list] {
    std::vector<std::string> ids = list->ids(scene_);
    ids.push_back(scene::newId(*list, scene_));
    sendItems(*list, ids, wordsFor(*list).add);
  });
}

void SettingsPanel::sendItems(const scene::SceneList& list, const std::vector<std::string>& ids,
                              const QString& name) {
  Edit edit{scene_, name, {}, false};
  list.arrange(edit.scene, ids);
  Q_EMIT edited(edit);
}

// A row for each setting of each item that there may be: those of items that the scene lacks are hidden.
void SettingsPanel::addItemRows(Group& group) {
  for (std::size_t position = 0; position < group.list->most; ++position) {
    for (const scene::SettingInfo& field : group.list->fields) {
      const std::string path = std::string(group.list->path)
                                   .append(".")
                                   .append(std::to_string(position + 1))
                                   .append(".")
                                   .append(scene::nameOfField(*group.list, field));
      group.rows.push_back(addRow(scene::setting(path), group));
      if (!path.ends_with(".shown")) continue;
      auto* remove = new QToolButton(group.rows.back().line);
      remove->setIcon(icon("close"));
      remove->setAutoRaise(true);
      nameAndTip(remove, wordsFor(*group.list).remove);
      group.rows.back().line->layout()->addWidget(remove);
      group.removers.push_back(remove);
      connect(remove, &QToolButton::clicked, this, [this, list = group.list, position] {
        std::vector<std::string> left = list->ids(scene_);
        if (position < left.size()) left.erase(left.begin() + static_cast<std::ptrdiff_t>(position));
        sendItems(*list, left, wordsFor(*list).remove);
      });
    }
  }
}

void SettingsPanel::showItems(const Group& group) {
  const std::vector<std::string> ids = group.list->ids(scene_);
  for (const Row& row : group.rows) {
    const std::string& path = row.editor->setting().path;
    const auto position = scene::positionOf(scene_, path);
    if (position && path.ends_with(".shown"))
      row.label->setText(titleOf(*group.list, scene_, ids[*position]));
  }
  for (QToolButton* remove : group.removers) remove->setVisible(ids.size() > group.list->least);
  const bool full = ids.size() >= group.list->most;
  group.addItem->setEnabled(!full);
  group.addItem->setToolTip(full ? wordsFor(*group.list).most.arg(group.list->most) : QString());
}

SettingsPanel::Row SettingsPanel::addRow(const scene::Setting& setting, const Group& group) {
  auto* editor = new SettingEditor(setting, group.box);
  const RowLabel words = labelOf(setting);
  auto* label = wrappedLabel(words.text, group.box);
  label->setBuddy(editor->valueWidget());
  auto* line = new QWidget(group.box);
  Row row{editor, label, line, wordsToSearch(setting, words.text, group.header->text())};
  const bool wide = editor->isWide();
  auto* both = new QBoxLayout(wide ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight, line);
  both->setContentsMargins(0, wide ? 2 : 0, 0, 0);
  both->setSpacing(wide ? 4 : 10);
  both->addWidget(label);
  both->addWidget(editor, 1);
  if (!wide) label->setFixedWidth(labelWidth);
  if (words.indented) label->setContentsMargins(indentation, 0, 0, 0);
  group.box->layout()->addWidget(line);
  holdRows(editor);
  if (turnsEnvironment(setting))
    connect(editor, &SettingEditor::edited, this,
            [this](const Edit& edit) { Q_EMIT edited(lettingMove(edit)); });
  else
    connect(editor, &SettingEditor::edited, this, &SettingsPanel::edited);
  connect(editor, &SettingEditor::dragStarted, this, &SettingsPanel::dragStarted);
  connect(editor, &SettingEditor::dragEnded, this, &SettingsPanel::dragEnded);
  connect(editor, &SettingEditor::failed, this, &SettingsPanel::failed);
  return row;
}

void SettingsPanel::holdRows(SettingEditor* editor) {
  connect(editor, &SettingEditor::dragStarted, this, [this] { dragging_ = true; });
  connect(editor, &SettingEditor::dragEnded, this, [this] {
    dragging_ = false;
    showRows();
  });
  connect(editor, &SettingEditor::edited, this, [this](const Edit& edit) {
    if (edit.endsAfterPause) settle_.start();
  });
}

// Whether the setting is of every scene, or of an item that this one has.
bool SettingsPanel::isThere(const std::string& path) const {
  return scene::listOfPath(path) == nullptr || scene::positionOf(scene_, path).has_value();
}

bool SettingsPanel::searching() const {
  return !search_->text().trimmed().isEmpty();
}

void SettingsPanel::showGroup(Group& group) {
  const auto useful = [](const Row& row) { return row.editor->whyInactive().isEmpty(); };
  const QString why =
      group.list != nullptr ? whyUseless(*group.list, scene_) : group.rows.front().editor->whyInactive();
  const bool anyUseful =
      (group.list != nullptr && why.isEmpty()) || std::any_of(group.rows.begin(), group.rows.end(), useful);
  const bool anyFound =
      std::any_of(group.rows.begin(), group.rows.end(), [](auto& row) { return row.found; });
  for (Row& row : group.rows) {
    const bool there = group.list == nullptr || isThere(row.editor->setting().path);
    const bool shown =
        searching() ? row.found && there : useful(row) && !shownByThumbnails(row.editor->setting());
    const QString tip = row.editor->toolTip();
    if (row.label->toolTip() != tip) row.label->setToolTip(tip);
    row.label->setEnabled(useful(row));
    if (shown == row.shown) continue;
    row.shown = shown;
    row.line->setVisible(shown);
  }
  const bool open = searching() ? anyFound : group.open && anyUseful;
  group.header->setVisible(!searching() || anyFound);
  group.header->setEnabled(searching() || anyUseful);
  group.header->setToolTip(anyUseful ? QString() : tr("No setting in this group has an effect: %1").arg(why));
  group.header->setChecked(open);
  group.header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  group.box->setVisible(open);
}

void SettingsPanel::search(const QString& text) {
  const QStringList wanted =
      text.toLower().replace("colour", "color").replace('_', ' ').split(' ', Qt::SkipEmptyParts);
  bool any = false;
  for (Group& group : groups_) {
    for (Row& row : group.rows) {
      row.found = std::all_of(wanted.begin(), wanted.end(),
                              [&row](const QString& word) { return row.words.contains(word); });
      any = any || row.found;
    }
    showGroup(group);
  }
  nothing_->setVisible(!any);
}

void SettingsPanel::setVolume(const VolumePointer& volume) {
  environment_->setAxes(volume->volume.axes);
}

void SettingsPanel::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  lights_->setScene(scene);
  for (Group& group : groups_)
    if (group.list != nullptr) showItems(group);
  environment_->setScene(scene, resolved);
  for (const Group& group : groups_)
    for (const Row& row : group.rows) row.editor->setScene(scene, resolved);
  showRows();
}

void SettingsPanel::setReport(const render::FrameReport& report, const render::FrameRequest&) {
  for (Group& group : groups_) {
    for (const Row& row : group.rows) {
      if (!row.editor->setting().mayBeAutomatic) continue;
      const auto found = report.found.find(row.editor->setting().path);
      row.editor->setFound(found == report.found.end() ? nlohmann::json() : nlohmann::json(found->second));
    }
  }
}

void SettingsPanel::showRows() {
  if (dragging_ || settle_.isActive()) return;
  environment_->setVisible(environment_->hasProbe());
  for (Group& group : groups_) showGroup(group);
}

const SettingsPanel::Row* SettingsPanel::rowOf(const QString& path) const {
  const std::string wanted = scene::canonicalPath(scene_, path.toStdString());
  for (const Group& group : groups_)
    for (const Row& row : group.rows)
      if (scene::canonicalPath(scene_, row.editor->setting().path) == wanted) return &row;
  return nullptr;
}

SettingEditor* SettingsPanel::editor(const QString& path) const {
  const Row* const row = rowOf(path);
  return row ? row->editor : nullptr;
}

bool SettingsPanel::shows(const QString& path) const {
  const Row* const row = rowOf(path);
  return row && row->shown;
}

void SettingsPanel::focusSearch() {
  search_->setFocus();
  search_->selectAll();
}

}  // namespace isolux::ui
