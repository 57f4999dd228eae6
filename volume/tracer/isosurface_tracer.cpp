#include "volume/tracer/isosurface_tracer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "volume/tracer/kernels.h"
#include "volume/tracer/trace_tables.h"

namespace isolux::volume {

namespace tracing {

bool enterVolume(const View& view, const TraceRay& ray, glm::vec3& origin, float& tBegin) {
  double begin = 0.0, end = static_cast<double>(ray.tMaximum);
  int entryAxis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = static_cast<double>(ray.origin[axis]), d = static_cast<double>(ray.direction[axis]);
    const double last = view.dims[axis] - 1;
    if (d == 0.0) {
      if (!(o >= 0.0 && o <= last)) return false;
      continue;
    }
    const double in = ((d > 0.0 ? 0.0 : last) - o) / d;
    if (in > begin) {
      begin = in;
      entryAxis = axis;
    }
    end = std::min(end, ((d > 0.0 ? last : 0.0) - o) / d);
  }
  if (!(begin < end)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const double last = view.dims[axis] - 1;
    const double at =
        static_cast<double>(ray.origin[axis]) + begin * static_cast<double>(ray.direction[axis]);
    origin[axis] = static_cast<float>(std::clamp(at, 0.0, last));
    if (axis == entryAxis) origin[axis] = ray.direction[axis] > 0.0f ? 0.0f : static_cast<float>(last);
  }
  tBegin = static_cast<float>(begin);
  return true;
}

namespace {

const Kernels* kernelsOf(TracerTarget target) {
  if (target == TracerTarget::scalar) return &scalarKernels();
  if (target != TracerTarget::automatic) return simdKernels(target);
  for (const TracerTarget widest :
       {TracerTarget::avx512, TracerTarget::avx2, TracerTarget::sse4, TracerTarget::neon})
    if (const Kernels* kernels = simdKernels(widest)) return kernels;
  return &scalarKernels();
}

}  // namespace

}  // namespace tracing

IsosurfaceTracer::IsosurfaceTracer(std::shared_ptr<const Grid> grid, scene::Inside inside,
                                   base::Progress& progress, TracerTarget target, TracerReach reach)
    : grid_(std::move(grid)),
      tables_(tracing::TraceTables::of(grid_, progress)),
      view_(std::make_unique<tracing::View>()),
      kernels_(tracing::kernelsOf(target)) {
  assert(kernels_);
  const tracing::Kernels* const wanted = kernels_;
  const CellRanges& ranges = tables_->ranges();
  if (grid_->geometry().voxelCount() > reach.voxels || ranges.bytes() > reach.tableBytes)
    kernels_ = &tracing::scalarKernels();
  beyondSimd_ = kernels_ != wanted;
  view_->dims = grid_->dims();
  view_->blockDims = ranges.blockDims();
  view_->scale = (inside == scene::Inside::above) == (grid_->slope() > 0.0) ? 1.0f : -1.0f;
  view_->ranges = &ranges;
  if (ranges.bytes() > 0) view_->table = ranges.table();
  view_->cellBytes = ranges.cellBytes();
  std::visit(
      [&](const auto& voxels) {
        using T = typename std::decay_t<decltype(voxels)>::value_type;
        if constexpr (std::is_same_v<T, float>) {
          view_->float32 = voxels.data();
          const double range = grid_->storedMaximum() - grid_->storedMinimum();
          if (range > 0.0) view_->scale *= std::ldexp(1.0f, std::clamp(-std::ilogb(range), -126, 126));
        } else if constexpr (std::is_same_v<T, std::uint16_t>) {
          view_->unsigned16 = voxels.data();
        } else if constexpr (std::is_same_v<T, std::int16_t>) {
          view_->signed16 = voxels.data();
        } else {
          view_->signed16 = tables_->widened().data();
        }
      },
      grid_->voxels());
}

IsosurfaceTracer::~IsosurfaceTracer() = default;

std::vector<TracerTarget> IsosurfaceTracer::availableTargets() {
  std::vector<TracerTarget> list{TracerTarget::scalar};
  for (const TracerTarget target :
       {TracerTarget::sse4, TracerTarget::avx2, TracerTarget::avx512, TracerTarget::neon})
    if (tracing::simdKernels(target)) list.push_back(target);
  return list;
}

void IsosurfaceTracer::firstEntries(std::span<const TraceRay> rays, std::span<float> t) const {
  assert(rays.size() == t.size());
  if (view_->traceable())
    kernels_->firstEntries(*view_, rays.data(), rays.size(), t.data());
  else
    std::fill(t.begin(), t.end(), std::numeric_limits<float>::infinity());
}

void IsosurfaceTracer::anyEntries(std::span<const TraceRay> rays, std::span<std::uint8_t> hit) const {
  assert(rays.size() == hit.size());
  if (view_->traceable())
    kernels_->anyEntries(*view_, rays.data(), rays.size(), hit.data());
  else
    std::fill(hit.begin(), hit.end(), std::uint8_t{0});
}

void IsosurfaceTracer::gradients(std::span<const glm::vec3> voxels, std::span<glm::vec3> gradients) const {
  assert(voxels.size() == gradients.size());
  kernels_->gradients(*view_, voxels.data(), voxels.size(), gradients.data());
}

std::size_t IsosurfaceTracer::bytes() const {
  return tables_->bytes();
}

const char* IsosurfaceTracer::target() const {
  return kernels_->name;
}

}  // namespace isolux::volume
