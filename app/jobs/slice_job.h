// One slice with its letters, drawn on a background thread, which the owner polls.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <optional>

#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/slice/slice_plane.h"

namespace isolux::app {

// What a slice is drawn from. Orders that are equal give the same picture.
struct SliceOrder {
  std::shared_ptr<const volume::PreparedVolume> volume;
  volume::SlicePlane plane;
  // Of a resolved Scene.
  scene::Slice slice;
  scene::Isosurface isosurface;
  std::array<scene::ExtraIsosurface, scene::kExtraIsosurfaces> extraIsosurfaces;
  scene::Pieces pieces;
  std::optional<double> noise;  // derivatives.noise, where there is a noise band
  // A draft has one value for so many pixels of a row and of a column, and between them what lies between the
  // values; letters and place are those of the full picture. 1: no draft.
  int coarse = 1;
  double pixelRatio = 1.0;  // pixels of one of a screen at 100 %: texts and curves are so much larger
  bool operator==(const SliceOrder&) const = default;
};
// slice.position is left out: the plane has it.
SliceOrder sliceOrder(std::shared_ptr<const volume::PreparedVolume> volume, const volume::SlicePlane& plane,
                      const scene::Scene& resolved);

class SliceJob {
 public:
  explicit SliceJob(SliceOrder order);  // starts at once
  ~SliceJob();                          // stops; the thread ends elsewhere (base/retire.h)
  SliceJob(const SliceJob&) = delete;
  SliceJob& operator=(const SliceJob&) = delete;

  const SliceOrder& order() const { return work_->order; }
  void stop() { work_->progress.requestStop(); }
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  // After finished(): the picture and how long it took, or what went wrong.
  const render::ColorImage& picture() const { return work_->picture; }
  double milliseconds() const { return work_->milliseconds; }
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    SliceOrder order;
    base::Progress progress;
    render::ColorImage picture;
    double milliseconds = 0.0;
    std::atomic<bool> finished{false};
    std::optional<base::Error> error;
  };
  static void run(Work& work);
  static void draw(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
