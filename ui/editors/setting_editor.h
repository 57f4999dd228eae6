// One row of the settings panel: the fitting widget for one scene::Setting, made from its description alone.
#pragma once

#include <memory>

#include <QWidget>

#include "scene/settings/settings.h"
#include "ui/document/edit.h"
#include "ui/editors/value_widgets.h"

class QCheckBox;
class QToolButton;

namespace isolux::ui {

class SettingEditor : public QWidget {
  Q_OBJECT
 public:
  SettingEditor(const scene::Setting& setting, QWidget* parent);
  ~SettingEditor() override;

  const scene::Setting& setting() const { return setting_; }
  ValueWidget* valueWidget() const { return value_; }
  bool isWide() const;  // needs the whole width of the panel
  // Why the setting does nothing in this scene; empty: it acts.
  const QString& whyInactive() const { return whyInactive_; }
  // Shows the scene's value, or the resolved one where the scene's is automatic.
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  // What the picture found for the setting where it is automatic and nothing else says; null: nothing.
  void setFound(const nlohmann::json& value);
  void resetToDefault();

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void dragStarted();
  void dragEnded();
  void failed(const QString& message);

 private:
  void send(const nlohmann::json& value, bool endsAfterPause);
  nlohmann::json seenValue() const;  // the scene's, or the resolved one, or what was found; "auto": unknown
  void explain();

  const scene::Setting setting_;
  scene::Scene scene_, resolved_;
  const std::unique_ptr<nlohmann::json> shown_, found_;
  QString description_, whyInactive_;
  bool dragging_ = false;
  ValueWidget* value_;
  QCheckBox* automatic_ = nullptr;
  QToolButton* reset_;
};

}  // namespace isolux::ui
