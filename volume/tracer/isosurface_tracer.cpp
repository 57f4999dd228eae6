#include "volume/tracer/isosurface_tracer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "volume/tracer/hidden_table.h"
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
  const Kernels* const kernels = simdKernels(target);
  return kernels || target != TracerTarget::automatic ? kernels : &scalarKernels();
}

View otherSideOf(View view) {
  view.scale = -view.scale;
  view.insideIsOfPieces = !view.insideIsOfPieces;
  return view;
}

}  // namespace

}  // namespace tracing

struct IsosurfaceTracer::HidingView {
  std::shared_ptr<const tracing::HiddenTable> table;
  tracing::View view;
};

IsosurfaceTracer::IsosurfaceTracer(std::shared_ptr<const Grid> grid, scene::Inside inside,
                                   base::Progress& progress, TracerTarget target, TracerReach reach)
    : grid_(std::move(grid)),
      inside_(inside),
      target_(target),
      reach_(reach),
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

void IsosurfaceTracer::hide(std::span<const HiddenOfSurface> surfaces, base::Progress& progress) {
  std::vector<std::shared_ptr<const tracing::HiddenTable>> tables;
  if (view_->traceable())
    for (const HiddenOfSurface& surface : surfaces)
      if (surface.voxels && surface.voxels->any())
        tables.push_back(std::make_shared<const tracing::HiddenTable>(grid_, surface, progress));
  takeHidden(std::move(tables));
}

void IsosurfaceTracer::takeHidden(std::vector<std::shared_ptr<const tracing::HiddenTable>> tables) {
  hiding_.clear();
  for (std::shared_ptr<const tracing::HiddenTable>& table : tables) {
    tracing::View view = *view_;
    view.ranges = &table->ranges();
    view.table = view.ranges->table();
    view.shown = &table->shown();
    view.insideIsOfPieces = inside_ == table->surface().inside;
    hiding_.push_back({std::move(table), view});
  }
}

std::vector<HiddenOfSurface> IsosurfaceTracer::hidden() const {
  std::vector<HiddenOfSurface> surfaces;
  for (const HidingView& hiding : hiding_) surfaces.push_back(hiding.table->surface());
  return surfaces;
}

std::shared_ptr<const IsosurfaceTracer> IsosurfaceTracer::otherSide(base::Progress& progress) const {
  auto other =
      std::make_shared<IsosurfaceTracer>(grid_, scene::otherSide(inside_), progress, target_, reach_);
  std::vector<std::shared_ptr<const tracing::HiddenTable>> tables;
  for (const HidingView& hiding : hiding_) tables.push_back(hiding.table);
  other->takeHidden(std::move(tables));
  other->cut(cut_);
  return other;
}

std::shared_ptr<const IsosurfaceTracer> IsosurfaceTracer::withAllPieces() const {
  base::Progress progress;  // the tables are there
  auto whole = std::make_shared<IsosurfaceTracer>(grid_, inside_, progress, target_, reach_);
  whole->cut(cut_);
  return whole;
}

const tracing::View& IsosurfaceTracer::viewOf(float isovalue) const {
  for (const HidingView& hiding : hiding_)
    if (hiding.table->isovalue() == isovalue) return hiding.view;
  return *view_;
}

// Calls trace(view, rays, results) with the rays of each view.
template <class Result, class Trace>
void IsosurfaceTracer::forViews(std::span<const TraceRay> rays, std::span<Result> results,
                                const Trace& trace) const {
  if (rays.empty()) return;
  const tracing::View& first = viewOf(rays.front().isovalue);
  const auto ofFirst = [&](const TraceRay& ray) { return &viewOf(ray.isovalue) == &first; };
  if (hiding_.empty() || std::all_of(rays.begin(), rays.end(), ofFirst)) {
    trace(first, rays, results);
    return;
  }
  std::vector<const tracing::View*> views{view_.get()};
  for (const HidingView& hiding : hiding_) views.push_back(&hiding.view);
  std::vector<TraceRay> own;
  std::vector<std::size_t> places;
  std::vector<Result> ownResults;
  for (const tracing::View* const view : views) {
    own.clear();
    places.clear();
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (&viewOf(rays[i].isovalue) == view) {
        own.push_back(rays[i]);
        places.push_back(i);
      }
    ownResults.resize(own.size());
    trace(*view, std::span<const TraceRay>(own), std::span<Result>(ownResults));
    for (std::size_t i = 0; i < places.size(); ++i) results[places[i]] = ownResults[i];
  }
}

std::vector<TracerTarget> IsosurfaceTracer::availableTargets() {
  std::vector<TracerTarget> list{TracerTarget::scalar};
  for (const TracerTarget target :
       {TracerTarget::sse4, TracerTarget::avx2, TracerTarget::avx512, TracerTarget::neon})
    if (tracing::simdKernels(target)) list.push_back(target);
  return list;
}

void IsosurfaceTracer::KeptRays::clear() {
  rays.clear();
  of.clear();
  begins.clear();
}

// Light that comes in again through the face of a removed box may be inside the surface there, and then the
// surface stops it where it leaves.
template <class Trace>
void IsosurfaceTracer::forKept(std::span<const TraceRay> rays, const Trace& trace) const {
  const bool comesBack = !cut_.region().removed().empty();
  KeptRays kept;
  for (const Entered entered : {Entered::inside, Entered::outside}) {
    if (entered == Entered::outside && !comesBack) return;
    kept.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const TraceRay& ray = rays[i];
      const glm::dvec3 origin(ray.origin), direction(ray.direction);
      if (!(ray.tMaximum > 0.0f)) continue;
      for (const auto& [begin, end] :
           cut_.stretchesOf(grid_->valueOfStored(static_cast<double>(ray.isovalue)),
                            {origin, direction, 0.0, static_cast<double>(ray.tMaximum)})) {
        if (!(begin < end) || (entered == Entered::outside && begin == 0.0)) continue;
        kept.rays.push_back(ray);
        if (begin > 0.0) kept.rays.back().origin = glm::vec3(origin + begin * direction);
        kept.rays.back().tMaximum = static_cast<float>(end - begin);
        kept.of.push_back(i);
        kept.begins.push_back(static_cast<float>(begin));
      }
    }
    trace(kept, entered);
  }
}

void IsosurfaceTracer::entriesOf(std::span<const TraceRay> rays, Entered entered, std::span<float> t) const {
  forViews(rays, t, [&](const tracing::View& view, std::span<const TraceRay> of, std::span<float> result) {
    kernels_->firstEntries(entered == Entered::inside ? view : tracing::otherSideOf(view), of.data(),
                           of.size(), result.data());
  });
}

void IsosurfaceTracer::anyOf(std::span<const TraceRay> rays, Entered entered,
                             std::span<std::uint8_t> hit) const {
  forViews(rays, hit,
           [&](const tracing::View& view, std::span<const TraceRay> of, std::span<std::uint8_t> result) {
             kernels_->anyEntries(entered == Entered::inside ? view : tracing::otherSideOf(view), of.data(),
                                  of.size(), result.data());
           });
}

void IsosurfaceTracer::firstEntries(std::span<const TraceRay> rays, std::span<float> t) const {
  assert(rays.size() == t.size());
  if (view_->traceable() && !cut_.cuts()) return entriesOf(rays, Entered::inside, t);
  std::fill(t.begin(), t.end(), std::numeric_limits<float>::infinity());
  if (!view_->traceable()) return;
  std::vector<float> found;
  forKept(rays, [&](const KeptRays& kept, Entered entered) {
    found.resize(kept.rays.size());
    entriesOf(kept.rays, entered, found);
    for (std::size_t i = 0; i < found.size(); ++i)
      t[kept.of[i]] = std::min(t[kept.of[i]], kept.begins[i] + found[i]);
  });
}

void IsosurfaceTracer::anyEntries(std::span<const TraceRay> rays, std::span<std::uint8_t> hit) const {
  assert(rays.size() == hit.size());
  if (view_->traceable() && !cut_.cuts()) return anyOf(rays, Entered::inside, hit);
  std::fill(hit.begin(), hit.end(), std::uint8_t{0});
  if (!view_->traceable()) return;
  std::vector<std::uint8_t> found;
  forKept(rays, [&](const KeptRays& kept, Entered entered) {
    found.resize(kept.rays.size());
    anyOf(kept.rays, entered, found);
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i] != 0) hit[kept.of[i]] = 1;
  });
}

void IsosurfaceTracer::gradients(std::span<const glm::vec3> voxels, std::span<glm::vec3> gradients) const {
  assert(voxels.size() == gradients.size());
  kernels_->gradients(*view_, voxels.data(), voxels.size(), gradients.data());
}

std::size_t IsosurfaceTracer::bytes() const {
  std::size_t bytes = tables_->bytes();
  for (const HidingView& hiding : hiding_) bytes += hiding.table->ranges().bytes();
  return bytes;
}

const char* IsosurfaceTracer::target() const {
  return kernels_->set.name;
}

}  // namespace isolux::volume
