// All settings of the scene as a panel, generated from scene::settings(): a new setting appears by itself.
//
// What does nothing under the current choices (scene/rules/relevance.h) is not shown; a search finds it all
// the same and says why it does nothing.
#pragma once

#include <string>
#include <vector>

#include <QTimer>
#include "ui/panels/panel.h"
#include "ui/panels/panel_layout.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QToolButton;
class QBoxLayout;

namespace isolux::ui {

class EnvironmentPreview;
class LightChooser;
class SettingEditor;

class SettingsPanel : public Panel {
  Q_OBJECT
 public:
  explicit SettingsPanel(QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume) override;
  void setScene(const scene::Scene& scene, const scene::Scene& resolved) override;
  void setReport(const render::FrameReport& report, const render::FrameRequest& request) override;
  SettingEditor* editor(const QString& path) const;  // null: not edited here
  bool shows(const QString& path) const;             // the row is there, if its group is open
  QLineEdit* searchLine() const { return search_; }
  void focusSearch();

 private:
  struct Row {
    SettingEditor* editor;
    QLabel* label;
    QWidget* line;      // holds both; shown and hidden as a whole
    QString words;      // what a search looks through, in lower case
    bool found = true;  // by the search
    bool shown = true;
  };
  struct Group {
    QToolButton* header;
    QWidget* box;
    std::vector<Row> rows;
    bool open;                               // as the user left it
    const scene::SceneList* list = nullptr;  // whose items the rows belong to
    QPushButton* addItem = nullptr;
    std::vector<QToolButton*> removers{};
  };
  void addGroup(const PanelGroup& plan, QBoxLayout* layout);
  Row addRow(const scene::Setting& setting, const Group& group);
  void addItemRows(Group& group);
  void showItems(const Group& group);  // titles, and what can be added and removed
  bool isThere(const std::string& path) const;
  void sendItems(const scene::SceneList& list, const std::vector<std::string>& ids, const QString& name);
  const Row* rowOf(const QString& path) const;  // null: not edited here
  void holdRows(SettingEditor* editor);
  void showRows();
  void showGroup(Group& group);
  void search(const QString& text);
  bool searching() const;

  QLineEdit* search_;
  QScrollArea* scroll_;
  QLabel* nothing_;
  LightChooser* lights_;
  EnvironmentPreview* environment_;
  std::vector<Group> groups_;
  scene::Scene scene_;
  // While a value is dragged, or turned by the wheel or keys, no row comes or goes: none may slip under the
  // pointer.
  bool dragging_ = false;
  QTimer settle_;
};

}  // namespace isolux::ui
