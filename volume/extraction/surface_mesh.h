// A triangle mesh of an isosurface, for printing and simulation: extracted by flying edges, its points moved
// onto the exact surface, finer where triangles leave it.
//
// Flying edges decide ambiguous cells by a table, so that pieces may hang together there that the interpolant
// parts, or the other way round; the mesh has no holes by that. Sheets that touch at a voxel whose value is
// the isovalue stay a thousandth of a voxel off it, so that the mesh is a manifold. Cells with a missing
// corner hold no surface.
#pragma once

#include <cstddef>

#include "base/progress.h"
#include "scene/choices.h"
#include "volume/field/coefficients.h"
#include "volume/mesh/triangle_mesh.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/visible/voxel_mask.h"

namespace isolux::volume {

struct SurfaceMeshRequest {
  double isovalue = 0.0;  // data units
  scene::Inside inside = scene::Inside::above;
  scene::Field field = scene::Field::trilinear;  // whose surface the points lie on
  const Coefficients* coefficients = nullptr;    // of cubic_interpolating
  const VoxelMask* hidden = nullptr;             // pieces that are left out
  bool closed = false;                           // where the surface leaves the volume the border closes it
  double toleranceMm = 0.0;                      // triangles are split until they come so near; 0: none is
  std::size_t budgetBytes = std::size_t{1} << 40;
};

struct SurfaceMesh {
  TriangleMesh mesh;  // world, mm; seen from outside counter-clockwise
  // The largest distance between the surface and a point of the mesh, mm, of those that were looked at: the
  // middles of edges and triangles; where no surface is found straight above or below one, that of its
  // nearest corner. Points that close the surface at the border are not on it, and alone are no surface.
  double largestDistanceMm = 0.0;
  glm::dvec3 farthest{0.0};  // that point, world mm
  // Of those points, how many lie farther off than toleranceMm, which was asked for: no surface is found
  // straight above or below, so that splitting there would lead to another part of it.
  std::size_t beyond = 0;
  double toleranceMm = 0.0;
  // Corners that lie beside the surface, because none is found near them (thin parts of cubic fields).
  std::size_t astray = 0;
  std::size_t openEdges = 0;  // of one triangle only, or of more than two
};

// Throws Error: memory (above the budget), interrupted, and those of the reader.
SurfaceMesh surfaceMesh(const Grid& grid, const SurfaceMeshRequest& request, base::Progress& progress);

// About how many triangles a mesh of the isovalue has before any is split, from the cells of some blocks, in
// milliseconds. 0 without a surface, and of a grid whose voxels stay in their file.
std::size_t estimatedTriangles(const Grid& grid, const MinMaxBlocks& blocks, double isovalue);

}  // namespace isolux::volume
