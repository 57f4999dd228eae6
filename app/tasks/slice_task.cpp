#include "app/tasks/slice_task.h"

#include <chrono>
#include <string>
#include <utility>

#include "app/slices/slice_draft.h"
#include "app/slices/slice_labels.h"
#include "app/slices/slice_picture.h"

namespace isolux::app {

SliceOrder sliceOrder(std::shared_ptr<const volume::PreparedVolume> volume, const volume::SlicePlane& plane,
                      const scene::Scene& resolved) {
  SliceOrder order{std::move(volume), plane, {}};
  order.scene.slice = resolved.slice;
  order.scene.isosurface = resolved.isosurface;
  order.scene.surfaces = resolved.surfaces;
  order.scene.pieces = resolved.pieces;
  order.scene.slice.position.reset();
  if (resolved.slice.noiseBand > 0.0) order.scene.derivatives.noise = resolved.derivatives.noise;
  return order;
}

namespace {

render::ColorImage drawn(const SliceOrder& order, base::Progress& progress) {
  const volume::Volume& volume = order.volume->volume;
  const SliceContent content =
      sliceContent(*order.volume, order.scene, coarsened(order.plane, order.coarse), progress);
  scene::Slice shown = order.scene.slice;
  shown.contourWidth *= order.pixelRatio / order.coarse;
  render::ColorImage picture = enlarged(slicePicture(content, shown, volume.grid->geometry(), progress),
                                        order.coarse, order.plane.size);
  drawWords(wordsOf(content, order.plane, order.scene.slice, volume), picture, order.pixelRatio);
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
