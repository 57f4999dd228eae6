// Measures of an isosurface: area and volume against those of VTK's mesh, ways along it, thickness.
#include <cmath>
#include <cstdio>

#include <glm/geometric.hpp>

#include "bench/bench.h"
#include "bench/subjects.h"
#include "bench/triangles.h"
#include "volume/measure/geodesic.h"
#include "volume/measure/surface_measure.h"
#include "volume/measure/thickness.h"

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

struct MeshSize {
  double areaMm2 = 0.0, volumeMm3 = 0.0;
};

// Of the mesh of VTK's flying edges; the volume by the divergence theorem, right for closed surfaces.
MeshSize meshSize(const volume::Grid& grid, double isovalue) {
  const Triangles mesh = trianglesOf(grid, isovalue);
  const glm::dmat4& world = grid.geometry().worldFromVoxel;
  const auto corner = [&](std::size_t i) {
    return glm::dvec3(world * glm::dvec4(glm::dvec3(mesh.points[mesh.corners[i]]), 1.0));
  };
  MeshSize size;
  for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
    const glm::dvec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
    size.areaMm2 += 0.5 * glm::length(glm::cross(b - a, c - a));
    size.volumeMm3 += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  size.volumeMm3 = std::abs(size.volumeMm3);
  return size;
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
  const MeshSize mesh = meshSize(grid, subject.isovalue);
  std::printf(" flying edges: area %+.3f %%", 100.0 * (mesh.areaMm2 / surface.areaMm2.value - 1.0));
  if (!surface.open())
    std::printf(", volume %+.3f %%", 100.0 * (mesh.volumeMm3 / surface.volumeMm3.value - 1.0));
  std::printf(surface.open() ? "; the surface is open\n" : "\n");
  printComparison(
      {"area and volume", "flying edges and sums over its triangles", "the net of the surface",
       "a way along it", "the largest ball at a point"},
      medians({[&] { volume::measureSurface(grid, blocks, {.isovalue = subject.isovalue}, progress); },
               [&] { meshSize(grid, subject.isovalue); },
               [&] { volume::surfaceGraph(grid, blocks, subject.isovalue, progress); },
               [&] { volume::geodesic(of, graph, a, b, progress); },
               [&] {
                 if (point) volume::inscribedBall(of, graph, *point);
               }},
              5));
}

void run() {
  for (const Subject& subject : subjects()) measureSubject(subject);
}

const Registration registration("measures", "area, volume, ways along the surface and thickness", run);

}  // namespace
}  // namespace isolux::bench
