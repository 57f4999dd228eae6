// Camera rays on one thread: the caster of pictures against the tracer of light, on the same rays; medians.
#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/bench.h"
#include "bench/frame.h"
#include "bench/subjects.h"
#include "render/passes/view_uniforms.h"
#include "volume/cast/surface_caster.h"
#include "volume/derived/cubic_fields.h"
#include "volume/skip/active_blocks.h"
#include "volume/skip/box_bounds.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::bench {
namespace {

constexpr int rounds = 7;
constexpr int tile = 16;

void compare(const Subject& subject) {
  scene::Scene wanted;
  wanted.surfaces.front().value = subject.isovalue;
  const scene::Scene scene = scene::resolve(wanted, subject.volume->facts);
  const volume::Grid& grid = subject.volume->grid();
  const render::ViewUniforms view(scene.camera, 1.0, grid.geometry());
  const volume::PictureRays rays = view.rays(pictureSize, glm::ivec2(0));
  const double stored = grid.storedOfValue(subject.isovalue);
  const float isovalue = static_cast<float>(stored);

  std::vector<std::uint8_t> flags;
  std::vector<std::uint64_t> masks;
  const auto activate = [&] {
    subject.volume->blocks->activeBlocks(isovalue, flags);
    subject.volume->boxes->masks({&isovalue, 1}, flags, masks);
  };
  activate();
  const volume::SurfaceCaster caster({grid}, {&stored, 1}, subject.volume->blocks->dims(), masks);
  const std::size_t count = static_cast<std::size_t>(pictureSize.x) * static_cast<std::size_t>(pictureSize.y);
  std::vector<glm::vec4> points(count);
  std::vector<glm::vec2> infos(count);
  volume::StartDepths depths;
  const auto project = [&] { depths = caster.startDepths(rays, pictureSize); };
  project();
  const auto cast = [&] {
    caster.cast(
        rays, depths,
        {glm::ivec2(0), pictureSize, points.data(), infos.data(), static_cast<std::size_t>(pictureSize.x)});
  };

  base::Progress progress;
  const auto cubic = subject.volume->cubicFields->make(scene::Field::cubic, progress);
  std::vector<std::uint64_t> cubicMasks;
  cubic->blocks.activeBlocks(isovalue, flags);
  cubic->boxes.masks({&isovalue, 1}, flags, cubicMasks);
  // Made anew for each picture, as the renderer does: which cells can hold a crossing is part of the cost.
  const auto castCubic = [&] {
    const volume::SurfaceCaster cubicCaster({grid, scene::Field::cubic}, {&stored, 1}, cubic->blocks.dims(),
                                            cubicMasks);
    cubicCaster.cast(
        rays, cubicCaster.startDepths(rays, pictureSize),
        {glm::ivec2(0), pictureSize, points.data(), infos.data(), static_cast<std::size_t>(pictureSize.x)});
  };

  const volume::IsosurfaceTracer tracer(subject.volume->volume.grid, scene::Inside::above, progress);
  std::vector<volume::TraceRay> traceRays;
  std::vector<float> t(count);
  for (int y0 = 0; y0 < pictureSize.y; y0 += tile)
    for (int x0 = 0; x0 < pictureSize.x; x0 += tile)
      for (int i = 0; i < tile * tile; ++i) {
        const glm::vec2 pixel(x0 + i % tile, y0 + i / tile);
        const glm::vec2 plane = ((pixel + 0.5f) / glm::vec2(pictureSize) * 2.0f - 1.0f) * rays.halfExtent;
        const glm::vec3 offset = plane.x * rays.right + plane.y * rays.up;
        traceRays.push_back(
            {rays.eye, (rays.forward + offset) / std::sqrt(1.0f + glm::dot(plane, plane)), isovalue});
      }
  const auto trace = [&] { tracer.firstEntries(traceRays, t); };

  std::size_t hits = 0, same = 0;
  cast();
  trace();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t block = i / (tile * tile),
                      blocksPerRow = static_cast<std::size_t>(pictureSize.x / tile);
    const std::size_t x = block % blocksPerRow * tile + i % tile,
                      y = block / blocksPerRow * tile + i % (tile * tile) / tile;
    const float own = points[y * static_cast<std::size_t>(pictureSize.x) + x].w;
    hits += own >= 0.0f;
    same += (own >= 0.0f) == std::isfinite(t[i]) && (own < 0.0f || std::fabs(own - t[i]) < 0.02f);
  }
  std::printf(" %s: %zu of %zu rays hit (%s), %.4f %% as the tracer\n", subject.name.c_str(), hits, count,
              volume::SurfaceCaster::target(),
              100.0 * static_cast<double>(same) / static_cast<double>(count));
  printComparison({"tracer, first entries", "caster, first crossings", "the same of the cubic field",
                   "caster, start depths", "masks of the isovalue"},
                  medians({trace, cast, castCubic, project, activate}, rounds));
}

void run() {
  std::vector<Subject> list = subjects();
  list.push_back({"torus 128", load("phantom:torus:128"), 0.0});
  for (const Subject& subject : list) compare(subject);
}

const Registration registration(
    "camera_rays", "camera rays on one thread: the caster of pictures against the light's tracer", run);

}  // namespace
}  // namespace isolux::bench
