#include "volume/tracer/isosurface_tracer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "volume/hit/shown_cells.h"
#include "volume/skip/cell_ranges.h"
#include "volume/tracer/kernels.h"
#include "volume/tracer/trace_tables.h"

namespace isolux::volume {

namespace tracing {

namespace {

// Comparisons with NaN are false.
bool isRay(const TraceRay& ray) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(ray.origin[axis]) || !std::isfinite(ray.direction[axis])) return false;
  return std::isfinite(ray.isovalue) && ray.direction != glm::vec3(0.0f) && ray.tMaximum > 0.0f;
}

bool isWithin(const View& view, glm::vec3 origin) {
  return glm::all(glm::greaterThanEqual(origin, glm::vec3(0.0f))) &&
         glm::all(glm::lessThanEqual(origin, glm::vec3(view.dims - 1)));
}

// False: the ray passes the volume by.
bool moveToFace(const View& view, TraceRay& ray, float& tBegin) {
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
    ray.origin[axis] = static_cast<float>(std::clamp(at, 0.0, last));
    if (axis == entryAxis) ray.origin[axis] = ray.direction[axis] > 0.0f ? 0.0f : static_cast<float>(last);
  }
  tBegin = static_cast<float>(begin);
  return true;
}

View otherSideOf(View view) {
  view.scale = -view.scale;
  view.insideIsOfPieces = !view.insideIsOfPieces;
  return view;
}

}  // namespace

// What rays of one isovalue skip by where some of its pieces are hidden: made once for a tracer and that of
// the other side.
class HiddenTable {
 public:
  // Multithreaded. Throws Error: interrupted; memory, before anything is made.
  HiddenTable(std::shared_ptr<const Grid> of, HiddenOfSurface hidden, base::Progress& progress)
      : held(base::machineMemory().reserve(
            CellRanges::bytesOf(of->dims()) + of->geometry().voxelCount(),
            "the tables of light tracing with hidden components",
            "a volume of fewer voxels, showing all components or gi.mode=off needs less")),
        grid(std::move(of)),
        surface(std::move(hidden)),
        level(InsideLevel::of(*grid, surface.isovalue, surface.inside)),
        ranges(*grid, progress, surface.voxels.get(), level.high),
        shown(*grid, surface.voxels.get(), surface.isovalue, surface.inside) {
    held.shrinkTo(ranges.bytes());
  }

  base::MemoryBudget::Held held;
  std::shared_ptr<const Grid> grid;
  HiddenOfSurface surface;
  InsideLevel level;  // of rays: its level is their isovalue
  CellRanges ranges;
  ShownCells shown;  // refers to what stands before it
};

float enterVolume(const View& view, TraceRay& ray) {
  float begin = 0.0f;
  if (!isRay(ray) || (!isWithin(view, ray.origin) && !moveToFace(view, ray, begin)))
    ray = {glm::vec3(0.0f), glm::vec3(0.0f), 0.0f, 0.0f};
  return begin;
}

}  // namespace tracing

struct IsosurfaceTracer::HidingView {
  std::shared_ptr<const tracing::HiddenTable> table;
  tracing::View view;
};

IsosurfaceTracer::IsosurfaceTracer(std::shared_ptr<const Grid> grid, scene::Inside inside,
                                   base::Progress& progress, TracerTarget target, bool wide)
    : grid_(std::move(grid)),
      inside_(inside),
      target_(target),
      tables_(tracing::TraceTables::of(grid_, progress)),
      view_(std::make_unique<tracing::View>()),
      kernels_(tracing::kernelsOf(target)) {
  assert(kernels_);
  const CellRanges& ranges = tables_->ranges();
  view_->dims = grid_->dims();
  view_->blockDims = ranges.blockDims();
  view_->scale = (inside == scene::Inside::above) == (grid_->slope() > 0.0) ? 1.0f : -1.0f;
  view_->ranges = &ranges;
  if (ranges.bytes() > 0) view_->table = ranges.table();
  view_->cellBytes = ranges.cellBytes();
  view_->wide =
      wide || grid_->geometry().voxelCount() > std::size_t{1} << 32 || ranges.bytes() > std::size_t{1} << 33;
  grid_->visit([&](const auto& voxels) {
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
  });
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
    view.ranges = &table->ranges;
    view.table = view.ranges->table();
    view.shown = &table->shown;
    view.insideIsOfPieces = inside_ == table->surface.inside;
    hiding_.push_back({std::move(table), view});
  }
}

std::vector<HiddenOfSurface> IsosurfaceTracer::hidden() const {
  std::vector<HiddenOfSurface> surfaces;
  for (const HidingView& hiding : hiding_) surfaces.push_back(hiding.table->surface);
  return surfaces;
}

std::shared_ptr<const IsosurfaceTracer> IsosurfaceTracer::otherSide(base::Progress& progress) const {
  auto other =
      std::make_shared<IsosurfaceTracer>(grid_, scene::otherSide(inside_), progress, target_, view_->wide);
  std::vector<std::shared_ptr<const tracing::HiddenTable>> tables;
  for (const HidingView& hiding : hiding_) tables.push_back(hiding.table);
  other->takeHidden(std::move(tables));
  other->cut(cut_);
  return other;
}

std::shared_ptr<const IsosurfaceTracer> IsosurfaceTracer::withAllPieces() const {
  base::Progress progress;  // the tables are there
  auto whole = std::make_shared<IsosurfaceTracer>(grid_, inside_, progress, target_, view_->wide);
  whole->cut(cut_);
  return whole;
}

const tracing::View& IsosurfaceTracer::viewOf(float isovalue) const {
  for (const HidingView& hiding : hiding_)
    if (hiding.table->level.level == isovalue) return hiding.view;
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
  std::vector<TracerTarget> list{TracerTarget::scalar, TracerTarget::sse4, TracerTarget::avx2,
                                 TracerTarget::avx512, TracerTarget::neon};
  std::erase_if(list, [](TracerTarget target) { return !tracing::kernelsOf(target); });
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
           cut_.segmentsOf(grid_->valueOfStored(static_cast<double>(ray.isovalue)),
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

// Calls take(i, begin, result) with what is found of each part of ray i that is kept, where that begins.
template <class Result, class Trace, class Take>
void IsosurfaceTracer::trace(std::span<const TraceRay> rays, std::span<Result> results, Result none,
                             const Trace& kernel, const Take& take) const {
  assert(rays.size() == results.size());
  const auto traceOf = [&](Entered entered) {
    return [&, entered](const tracing::View& view, std::span<const TraceRay> of, std::span<Result> result) {
      kernel(entered == Entered::inside ? view : tracing::otherSideOf(view), of.data(), of.size(),
             result.data());
    };
  };
  if (view_->traceable() && !cut_.cuts()) return forViews(rays, results, traceOf(Entered::inside));
  std::fill(results.begin(), results.end(), none);
  if (!view_->traceable()) return;
  std::vector<Result> found;
  forKept(rays, [&](const KeptRays& kept, Entered entered) {
    found.resize(kept.rays.size());
    forViews(std::span<const TraceRay>(kept.rays), std::span<Result>(found), traceOf(entered));
    for (std::size_t i = 0; i < found.size(); ++i) take(kept.of[i], kept.begins[i], found[i]);
  });
}

void IsosurfaceTracer::firstEntries(std::span<const TraceRay> rays, std::span<float> t) const {
  trace(rays, t, std::numeric_limits<float>::infinity(), kernels_->firstEntries,
        [t](std::size_t i, float begin, float found) { t[i] = std::min(t[i], begin + found); });
}

void IsosurfaceTracer::anyEntries(std::span<const TraceRay> rays, std::span<std::uint8_t> hit) const {
  trace(rays, hit, std::uint8_t{0}, kernels_->anyEntries,
        [hit](std::size_t i, float, std::uint8_t found) { hit[i] |= found; });
}

void IsosurfaceTracer::gradients(std::span<const glm::vec3> voxels, std::span<glm::vec3> gradients) const {
  assert(voxels.size() == gradients.size());
  kernels_->gradients(*view_, voxels.data(), voxels.size(), gradients.data());
}

std::size_t IsosurfaceTracer::bytes() const {
  std::size_t bytes = tables_->bytes();
  for (const HidingView& hiding : hiding_) bytes += hiding.table->ranges.bytes();
  return bytes;
}

const char* IsosurfaceTracer::target() const {
  return kernels_->set.name;
}

}  // namespace isolux::volume
