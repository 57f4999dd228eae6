// The picture alone, four-up with three slices beside it, or the slices alone.
//
// Slices are drawn only while they are shown; so is the picture.
#pragma once

#include <array>
#include <vector>

#include <QWidget>

#include "ui/slices/slice_view.h"

namespace isolux::ui {

enum class ViewLayout { picture, fourUp, slices };

class SliceBoard : public QWidget {
  Q_OBJECT
 public:
  explicit SliceBoard(QWidget* picture, QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  void setInteracting(bool interacting);  // a gesture elsewhere changes what slices show
  void arrange(ViewLayout layout);
  ViewLayout arrangement() const { return arrangement_; }
  bool slicesShown() const { return arrangement_ != ViewLayout::picture; }
  SliceView* view(volume::SliceDirection direction) const {
    return views_[static_cast<std::size_t>(direction)];
  }
  // Of the slices that are shown.
  std::vector<PlaneOfView> planes() const;

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void gestureEnded();
  void failed(const QString& message);
  void arranged(isolux::ui::ViewLayout layout);
  void planesChanged();  // planes() may be others

 private:
  void linkViews();

  QWidget* const picture_;
  std::array<SliceView*, 3> views_{};
  ViewLayout arrangement_ = ViewLayout::picture;
};

}  // namespace isolux::ui
