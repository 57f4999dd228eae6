#include "app/jobs/slice_job.h"

#include <new>
#include <utility>

#include "app/slices/slice_labels.h"
#include "app/slices/slice_picture.h"

namespace isolux::app {

SliceOrder sliceOrder(std::shared_ptr<const volume::PreparedVolume> volume, const volume::SlicePlane& plane,
                      const scene::Scene& resolved) {
  SliceOrder order;
  order.volume = std::move(volume);
  order.plane = plane;
  order.slice = resolved.slice;
  order.isosurface = resolved.isosurface;
  order.extraIsosurfaces = resolved.extraIsosurfaces;
  order.pieces = resolved.pieces;
  order.slice.position.reset();
  if (order.slice.noiseBand > 0.0) order.noise = resolved.derivatives.noise;
  return order;
}

SliceJob::SliceJob(SliceOrder order) : order_(std::move(order)) {
  thread_ = std::thread([this] { run(); });
}

SliceJob::~SliceJob() {
  progress_.requestStop();
  thread_.join();
}

void SliceJob::run() {
  try {
    scene::Scene scene;
    scene.slice = order_.slice;
    scene.isosurface = order_.isosurface;
    scene.extraIsosurfaces = order_.extraIsosurfaces;
    scene.pieces = order_.pieces;
    scene.derivatives.noise = order_.noise;
    const volume::Volume& volume = order_.volume->volume;
    const SliceContent content = sliceContent(*order_.volume, scene, order_.plane, progress_);
    picture_ = slicePicture(content, scene.slice, volume.grid->geometry(), progress_);
    drawWords({lettersOf(order_.plane, volume.axes), placeText(order_.plane, volume.axes),
               conventionText(scene.slice.convention, volume.axes),
               windowText(content, scene.slice, volume.unit), rulerOf(order_.plane)},
              picture_);
  } catch (const base::Error& error) {
    error_ = error;
  } catch (const std::bad_alloc&) {
    error_ = base::Error(base::ErrorKind::memory, order_.volume->volume.name, "",
                         "out of memory while a slice is drawn");
  }
  finished_.store(true, std::memory_order_release);
}

}  // namespace isolux::app
