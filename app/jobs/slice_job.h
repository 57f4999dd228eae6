// One slice with its letters, drawn on a background thread, which the owner polls.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "base/error.h"
#include "base/progress.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"
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
  bool operator==(const SliceOrder&) const = default;
};
// slice.position is left out: the plane has it.
SliceOrder sliceOrder(std::shared_ptr<const volume::PreparedVolume> volume, const volume::SlicePlane& plane,
                      const scene::Scene& resolved);

class SliceJob {
 public:
  explicit SliceJob(SliceOrder order);  // starts at once
  ~SliceJob();                          // stops and waits: a few ms

  const SliceOrder& order() const { return order_; }
  void stop() { progress_.requestStop(); }
  bool finished() const { return finished_.load(std::memory_order_acquire); }
  // After finished(): the picture, or what went wrong.
  const render::ColorImage& picture() const { return picture_; }
  const std::optional<base::Error>& error() const { return error_; }

 private:
  void run();

  const SliceOrder order_;
  base::Progress progress_;
  render::ColorImage picture_;
  std::atomic<bool> finished_{false};
  std::optional<base::Error> error_;
  std::thread thread_;
};

}  // namespace isolux::app
