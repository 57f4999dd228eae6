// Measures of an isosurface: area and volume against those of VTK's mesh, ways along it, thickness.
#include <cmath>
#include <cstdio>
#include <numbers>

#include <glm/geometric.hpp>

#include "bench/bench.h"
#include "bench/subjects.h"
#include "bench/triangles.h"
#include "volume/measure/geodesic.h"
#include "volume/measure/surface_measure.h"
#include "volume/measure/thickness.h"
#include "volume/phantom/phantom.h"

namespace isolux::bench {
namespace {

// Two points of the surface that lie far apart: the farthest from its middle, and the farthest from that.
std::pair<glm::dvec3, glm::dvec3> farPoints(const volume::SurfaceGraph& graph, glm::dvec3 middle) {
  const auto farthest = [&](glm::dvec3 from) {
    glm::dvec3 best = from;
    for (const glm::dvec3& p : graph.points)
      if (glm::length(p - from) > glm::length(best - from)) best = p;
    return best;
  };
  const glm::dvec3 a = farthest(middle);
  return {a, farthest(a)};
}

// Distances to a ball and a torus, whose sizes are known, against VTK's mass properties of the mesh.
void compareSolids(int size) {
  constexpr double pi = std::numbers::pi;
  const double edge = size - 1;  // mm: phantoms have voxels of 1 mm
  const double ball = 0.35 * edge, ring = 0.27 * edge, tube = 0.12 * edge;
  const struct {
    const char* phantom;
    double areaMm2, volumeMm3;
  } solids[] = {{"ball", 4.0 * pi * ball * ball, 4.0 / 3.0 * pi * ball * ball * ball},
                {"torus", 4.0 * pi * pi * ring * tube, 2.0 * pi * pi * ring * tube * tube}};
  for (const auto& solid : solids) {
    base::Progress progress;
    const volume::Grid grid =
        volume::makePhantom({.name = solid.phantom, .size = size, .geometry = {}}, progress);
    const volume::MinMaxBlocks blocks(grid, 8, progress);
    const auto ours = volume::measureSurface(grid, blocks, {.isovalue = 0.0}, progress);
    const MeshSize mesh = massOf(grid, 0.0);
    const auto percent = [](double value, double reference) { return 100.0 * (value / reference - 1.0); };
    std::printf(
        " %s %d: area %+.4f %% (states %.4f), VTK %+.4f %%; volume %+.4f %% (states %.4f), VTK %+.4f %%\n",
        solid.phantom, size, percent(ours.areaMm2.value, solid.areaMm2),
        100.0 * ours.areaMm2.error / solid.areaMm2, percent(mesh.areaMm2, solid.areaMm2),
        percent(ours.volumeMm3.value, solid.volumeMm3), 100.0 * ours.volumeMm3.error / solid.volumeMm3,
        percent(mesh.volumeMm3, solid.volumeMm3));
  }
}

void measureSubject(const Subject& subject) {
  const volume::Grid& grid = subject.volume->grid();
  const volume::MinMaxBlocks& blocks = *subject.volume->blocks;
  base::Progress progress;
  const auto surface = volume::measureSurface(grid, blocks, {.isovalue = subject.isovalue}, progress);
  const volume::SurfaceGraph graph = volume::surfaceGraph(grid, blocks, subject.isovalue, progress);
  const volume::SurfaceOf of{grid, subject.isovalue, scene::Inside::above, {}};
  const auto [a, b] =
      farPoints(graph, 0.5 * (subject.volume->facts.boundsMinMm + subject.volume->facts.boundsMaxMm));
  const auto point = volume::surfacePoint(of, a);
  std::printf(" %s: %zu cells, area %.0f +- %.0f mm^2, volume %.0f +- %.0f mm^3\n", subject.name.c_str(),
              surface.cells, surface.areaMm2.value, surface.areaMm2.error, surface.volumeMm3.value,
              surface.volumeMm3.error);
  const MeshSize mesh = massOf(grid, subject.isovalue);
  std::printf(" flying edges: area %+.3f %%", 100.0 * (mesh.areaMm2 / surface.areaMm2.value - 1.0));
  if (!surface.open())
    std::printf(", volume %+.3f %%", 100.0 * (mesh.volumeMm3 / surface.volumeMm3.value - 1.0));
  std::printf(surface.open() ? "; the surface is open\n" : "\n");
  printComparison(
      {"area and volume", "flying edges and VTK's mass properties", "the net of the surface",
       "a way along it", "the largest ball at a point"},
      medians({[&] { volume::measureSurface(grid, blocks, {.isovalue = subject.isovalue}, progress); },
               [&] { massOf(grid, subject.isovalue); },
               [&] { volume::surfaceGraph(grid, blocks, subject.isovalue, progress); },
               [&, from = a, to = b] { volume::geodesic(of, graph, from, to, progress); },
               [&] {
                 if (point) volume::inscribedBall(of, graph, *point);
               }},
              5));
}

void run() {
  for (const int size : {64, 128, 256}) compareSolids(size);
  for (const Subject& subject : subjects()) measureSubject(subject);
}

const Registration registration("measures", "area, volume, ways along the surface and thickness", run);

}  // namespace
}  // namespace isolux::bench
