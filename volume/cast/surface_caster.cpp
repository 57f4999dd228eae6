#include "volume/cast/surface_caster.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include "volume/cast/cast_kernels.h"
#include "volume/field/value_scaling.h"

namespace isolux::volume {

const char* SurfaceCaster::target() {
  const casting::CastKernels* const kernels = casting::castKernels(TracerTarget::automatic);
  return kernels ? kernels->name : nullptr;
}

SurfaceCaster::SurfaceCaster(const Grid& grid, std::span<const double> storedIsovalues, glm::ivec3 blocks,
                             std::span<const std::uint64_t> masks, TracerTarget wanted)
    : masks_(masks), view_(std::make_unique<casting::CastView>()), kernels_(casting::castKernels(wanted)) {
  assert(kernels_ && !storedIsovalues.empty() && storedIsovalues.size() <= 4);
  casting::CastView& view = *view_;
  view.dims = grid.dims();
  view.blockDims = blocks;
  view.masks = masks.data();
  view.gaps = grid.missingCount() > 0;
  std::visit([&](const auto& voxels) { view.voxels = voxels.data(); }, grid.voxels());
  const std::size_t bytes = bytesOf(grid.storedType());
  if (bytes == sizeof(float)) {
    const ValueScaling scaling = scalingOf(grid.storedMinimum(), grid.storedMaximum());
    view.offset = scaling.offset;
    view.scale = std::ldexp(1.0f, -scaling.exponent);
  } else {
    view.scale = bytes == 1 ? 1.0f / 255.0f : 1.0f / 65535.0f;
  }
  view.surfaces = static_cast<int>(storedIsovalues.size());
  view.isovalue = static_cast<float>(storedIsovalues[0] - static_cast<double>(view.offset));
  for (std::size_t k = 0; k < storedIsovalues.size(); ++k)
    view.shifts[k] = static_cast<float>(storedIsovalues[k] - storedIsovalues[0]) * view.scale;
}

SurfaceCaster::~SurfaceCaster() = default;

StartDepths SurfaceCaster::startDepths(const PictureRays& rays, glm::ivec2 size) const {
  return volume::startDepths(rays, size, view_->dims, {view_->blockDims, masks_});
}

void SurfaceCaster::cast(const PictureRays& rays, const StartDepths& depths, const CastTarget& target) const {
  assert(target.begin.x % StartDepths::kTile == 0 && target.begin.y % StartDepths::kTile == 0);
  kernels_->cast(*view_, rays, depths, target);
}

// Calls cast(target) for squares of all pixels, on all threads.
template <class Cast>
void SurfaceCaster::forPieces(glm::ivec2 size, std::span<glm::vec4> points, std::span<glm::vec2> infos,
                              const std::stop_token& stop, const Cast& cast) {
  assert(points.size() == infos.size() &&
         points.size() == static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  constexpr int piece = 32;  // pixels
  const glm::ivec2 pieces = (size + (piece - 1)) / piece;
  tbb::parallel_for(tbb::blocked_range2d<int>(0, pieces.y, 1, 0, pieces.x, 1), [&](const auto& range) {
    if (stop.stop_requested()) return;
    const glm::ivec2 begin = piece * glm::ivec2(range.cols().begin(), range.rows().begin());
    const glm::ivec2 end = glm::min(piece * glm::ivec2(range.cols().end(), range.rows().end()), size);
    cast(CastTarget{begin, end, points.data(), infos.data(), static_cast<std::size_t>(size.x)});
  });
}

void SurfaceCaster::castAll(const PictureRays& rays, glm::ivec2 size, std::span<glm::vec4> points,
                            std::span<glm::vec2> infos, const std::stop_token& stop) const {
  const StartDepths depths = startDepths(rays, size);
  forPieces(size, points, infos, stop, [&](const CastTarget& target) { cast(rays, depths, target); });
}

void SurfaceCaster::castBehind(const PictureRays& rays, glm::ivec2 size, const CrossingsBefore& before,
                               std::span<glm::vec4> points, std::span<glm::vec2> infos,
                               const std::stop_token& stop) const {
  assert(before.points.size() == points.size() && before.infos.size() == points.size() &&
         before.covered.size() == points.size());
  forPieces(size, points, infos, stop,
            [&](const CastTarget& target) { kernels_->castBehind(*view_, rays, before, target); });
}

}  // namespace isolux::volume
