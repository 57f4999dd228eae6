// All settings of the scene as a panel, generated from scene::settings(): a new setting appears by itself.
#pragma once

#include <vector>

#include <QScrollArea>

#include "ui/edit.h"

class QVBoxLayout;

namespace isolux::ui {

class SettingEditor;

class SettingsPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit SettingsPanel(QWidget* parent = nullptr);

  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  SettingEditor* editor(const QString& path) const;  // null: not shown here
  void expand(const QString& group);

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void dragStarted();
  void dragEnded();
  void failed(const QString& message);

 private:
  QWidget* addGroup(const QString& group, QVBoxLayout* layout);
  std::vector<SettingEditor*> editors_;
};

}  // namespace isolux::ui
