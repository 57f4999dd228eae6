// The picture alone, or four-up: with an axial, a coronal and a sagittal slice beside it.
//
// Slices are drawn only while they are shown.
#pragma once

#include <array>

#include <QWidget>

#include "ui/slices/slice_view.h"

namespace isolux::ui {

class SliceBoard : public QWidget {
  Q_OBJECT
 public:
  explicit SliceBoard(QWidget* picture, QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  void setFourUp(bool on);
  bool fourUp() const { return fourUp_; }
  SliceView* view(volume::SliceDirection direction) const {
    return views_[static_cast<std::size_t>(direction)];
  }

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void gestureEnded();
  void failed(const QString& message);

 private:
  std::array<SliceView*, 3> views_{};
  bool fourUp_ = false;
};

}  // namespace isolux::ui
