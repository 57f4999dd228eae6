// Traces many rays, each with its own isovalue, to where they first enter the inside of the trilinear
// isosurface: the CPU tracer of the light bake.
//
// Semantics as firstEntry() (tests/support/first_entry.h), in float: t agrees to about 1e-4 voxels where
// the ray is not grazing, and rays whose answer hangs on the last digits of the isovalue may differ.
// Positions are voxel coordinates, isovalues and gradients stored units (Grid::storedOfValue), t is in units
// of |direction|. Rays that are not finite or have no direction, NaN isovalues and grids without cells:
// nothing is hit. Const members are safe from many threads.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/choices.h"
#include "volume/clip/surface_cut.h"
#include "volume/grid.h"
#include "volume/simd/simd_set.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

namespace tracing {
class HiddenTable;
struct Kernels;
class TraceTables;
struct View;
}  // namespace tracing

struct TraceRay {
  glm::vec3 origin;     // voxel coordinates
  glm::vec3 direction;  // voxels per unit of t; need not be unit
  float isovalue;       // stored units
  float tMaximum = std::numeric_limits<float>::infinity();
};

class IsosurfaceTracer {
 public:
  // Builds what rays skip by, on all threads, or shares it with another tracer of the grid. Throws Error:
  // interrupted; memory, before anything is made.
  // `target`: automatic is the widest of this machine; one of availableTargets() for tests and benchmarks.
  // `wide`: with the 64-bit indices of volumes of more than 2^32 voxels, for tests.
  IsosurfaceTracer(std::shared_ptr<const Grid> grid, scene::Inside inside, base::Progress& progress,
                   TracerTarget target = TracerTarget::automatic, bool wide = false);
  ~IsosurfaceTracer();
  IsosurfaceTracer(const IsosurfaceTracer&) = delete;
  IsosurfaceTracer& operator=(const IsosurfaceTracer&) = delete;

  // What rays of these isovalues pass from now on; before anything is traced, once. Two bytes a voxel for
  // each isovalue with anything hidden. Throws as the constructor.
  void hide(std::span<const HiddenOfSurface> surfaces, base::Progress& progress);
  std::vector<HiddenOfSurface> hidden() const;
  // What is cut away of the isosurfaces from now on: rays meet only what is kept. Before anything is traced.
  void cut(const SurfaceCut& cut) { cut_ = cut; }
  const SurfaceCut& cut() const { return cut_; }
  // Of the other side, with the same tables, pieces and cuts; and of this side with all pieces shown. Throws
  // as the constructor.
  std::shared_ptr<const IsosurfaceTracer> otherSide(base::Progress& progress) const;
  std::shared_ptr<const IsosurfaceTracer> withAllPieces() const;

  // Those compiled in that this machine can run; scalar is always the first.
  static std::vector<TracerTarget> availableTargets();

  // t of the first entry in (0, tMaximum], +inf where there is none. Spans of equal length.
  void firstEntries(std::span<const TraceRay> rays, std::span<float> t) const;
  // 1 where firstEntries would find one, else 0; faster.
  void anyEntries(std::span<const TraceRay> rays, std::span<std::uint8_t> hit) const;

  // Gradient of the tri-cubic B-spline of the samples, stored units per voxel (sampleCubic without the
  // slope); that of the trilinear cell where one of the 64 samples is missing, 0 where one of those 8 is.
  // Positions are clamped to the domain.
  void gradients(std::span<const glm::vec3> voxels, std::span<glm::vec3> gradients) const;

  const Grid& grid() const { return *grid_; }
  std::size_t bytes() const;   // beside the grid; of all its tracers together
  const char* target() const;  // "AVX-512", "AVX2", "SSE4", "NEON" or "scalar"

 private:
  // Of rays of one isovalue, or of all others.
  struct HidingView;
  // The kept segments of rays, each a ray of its own: the index of the ray it is of, and where on it it
  // begins.
  struct KeptRays {
    std::vector<TraceRay> rays;
    std::vector<std::size_t> of;
    std::vector<float> begins;
    void clear();
  };

  void takeHidden(std::vector<std::shared_ptr<const tracing::HiddenTable>> tables);
  const tracing::View& viewOf(float isovalue) const;
  // Calls trace(kept, side) with the segments within the clipped volumes; then with those segments that lie
  // behind removed boxes, of the other side.
  template <class Trace>
  void forKept(std::span<const TraceRay> rays, const Trace& trace) const;
  enum class Entered { inside, outside };
  template <class Result, class Trace, class Take>
  void trace(std::span<const TraceRay> rays, std::span<Result> results, Result none, const Trace& kernel,
             const Take& take) const;
  template <class Result, class Trace>
  void forViews(std::span<const TraceRay> rays, std::span<Result> results, const Trace& trace) const;

  std::shared_ptr<const Grid> grid_;
  scene::Inside inside_;
  TracerTarget target_;
  std::shared_ptr<const tracing::TraceTables> tables_;
  std::unique_ptr<tracing::View> view_;
  std::vector<HidingView> hiding_;
  SurfaceCut cut_;
  const tracing::Kernels* kernels_;
};

}  // namespace isolux::volume
