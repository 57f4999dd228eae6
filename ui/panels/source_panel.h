// How the volume is made where there is a choice: a mesh's resolution, and the combination with a second
// volume.
#pragma once

#include <vector>

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/edit.h"

class QFormLayout;
class QPushButton;

namespace isolux::ui {

class SettingEditor;

class SourcePanel : public QWidget {
  Q_OBJECT
 public:
  explicit SourcePanel(QWidget* parent = nullptr);

  // Shows what applies to this volume and these settings. `volume` may be null.
  void show(const scene::Scene& scene, const VolumePointer& volume);
  SettingEditor* editor(const QString& path) const;

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void failed(const QString& message);

 private:
  void addEditor(const char* path, const QString& label);
  void chooseSecond();

  QFormLayout* form_;
  std::vector<SettingEditor*> editors_;
  QPushButton* choose_;
  scene::Scene scene_;
};

}  // namespace isolux::ui
