#include "app/jobs/slice_job.h"

#include <chrono>
#include <string>
#include <utility>

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

namespace {

render::ColorImage drawn(const SliceOrder& order, base::Progress& progress) {
  scene::Scene scene;
  scene.slice = order.slice;
  scene.isosurface = order.isosurface;
  scene.extraIsosurfaces = order.extraIsosurfaces;
  scene.pieces = order.pieces;
  scene.derivatives.noise = order.noise;
  const volume::Volume& volume = order.volume->volume;
  const SliceContent content =
      sliceContent(*order.volume, scene, coarsened(order.plane, order.coarse), progress);
  scene::Slice shown = scene.slice;
  shown.contourWidth *= order.pixelRatio / order.coarse;
  render::ColorImage picture = enlarged(slicePicture(content, shown, volume.grid->geometry(), progress),
                                        order.coarse, order.plane.size);
  drawWords(wordsOf(content, order.plane, scene.slice, volume), picture, order.pixelRatio);
  return picture;
}

}  // namespace

std::unique_ptr<SliceTask> sliceTask(SliceOrder asked) {
  const std::string file = asked.volume->volume.name;
  const auto work = [order = std::move(asked)](base::Progress& progress) {
    const auto begun = std::chrono::steady_clock::now();
    DrawnSlice slice{drawn(order, progress)};
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
    slice.milliseconds = took.count();
    return slice;
  };
  return SliceTask::start({file, "draw a slice"}, work);
}

}  // namespace isolux::app
