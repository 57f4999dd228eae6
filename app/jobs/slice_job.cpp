#include "app/jobs/slice_job.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/process/caught_error.h"
#include "app/slices/slice_draft.h"
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

SliceJob::SliceJob(SliceOrder order)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->order = std::move(order);
            return work;
          }(),
          run) {}

SliceJob::~SliceJob() {
  work_->progress.requestStop();
}

void SliceJob::draw(Work& work) {
  const SliceOrder& order = work.order;
  scene::Scene scene;
  scene.slice = order.slice;
  scene.isosurface = order.isosurface;
  scene.extraIsosurfaces = order.extraIsosurfaces;
  scene.pieces = order.pieces;
  scene.derivatives.noise = order.noise;
  const volume::Volume& volume = order.volume->volume;
  const SliceContent content =
      sliceContent(*order.volume, scene, coarsened(order.plane, order.coarse), work.progress);
  scene::Slice drawn = scene.slice;
  drawn.contourWidth *= order.pixelRatio / order.coarse;
  work.picture = enlarged(slicePicture(content, drawn, volume.grid->geometry(), work.progress), order.coarse,
                          order.plane.size);
  drawWords(wordsOf(content, order.plane, scene.slice, volume), work.picture, order.pixelRatio);
}

void SliceJob::run(Work& work) {
  const auto begun = std::chrono::steady_clock::now();
  work.error = caughtError(work.order.volume->volume.name, "draw a slice", [&] { draw(work); });
  work.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
