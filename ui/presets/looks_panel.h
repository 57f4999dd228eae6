// Presets and looks as small pictures of the present scene. Pointing at one previews it in the picture, a
// click makes it the scene: one step of undo. A preset that does not apply is dim and says why. The slider
// above shifts the isovalues of the preset that is shown.
#pragma once

#include <optional>
#include <vector>

#include <QTimer>

#include "app/presets/thumbnails.h"
#include "ui/panels/panel.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QSlider;

namespace isolux::ui {

class NumberSpinBox;
class ThumbnailPainter;

class LooksPanel : public Panel {
  Q_OBJECT
 public:
  explicit LooksPanel(QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume) override;
  void setScene(const scene::Scene& scene, const scene::Scene& resolved) override;
  void setDrawing(bool draws);  // the window's own picture comes first

  const ThumbnailPainter& painter() const { return *painter_; }
  const std::vector<app::Thumbnail>& thumbnails() const { return thumbnails_; }
  QListWidget* presetList() const { return presets_; }
  QListWidget* lookList() const { return looks_; }

 Q_SIGNALS:
  // The scene that the picture shows while one is pointed at; none: the document's again.
  void previewed(const std::optional<isolux::scene::Scene>& scene);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QListWidget* makeList(const QString& name);
  QWidget* makeShift();
  void readPresets();
  void refresh();  // what is shown, of the present scene
  void fillLists();
  void showPicture(int place);
  void fitLists();
  void pointAt(std::optional<std::size_t> place);
  void choose(const QListWidgetItem* item);
  void showShift();
  void sendShift(double shift, bool endsAfterPause);

  VolumePointer volume_;
  scene::Scene scene_;
  std::vector<app::Preset> list_;  // of the program, then the user's own
  std::vector<app::Thumbnail> thumbnails_;
  ThumbnailPainter* painter_;
  QListWidget *presets_, *looks_;
  QLabel* shiftLabel_ = nullptr;
  QSlider* shift_ = nullptr;
  NumberSpinBox* shiftBox_ = nullptr;
  std::optional<std::size_t> shifted_;  // of list_
  std::optional<std::size_t> pointed_;
  bool previewing_ = false;
  QTimer pointTimer_, refreshTimer_;
};

}  // namespace isolux::ui
