#include "volume/measure/surface_patches.h"

#include <limits>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/measure/surface_sums.h"

namespace isolux::volume {

namespace {

constexpr double kInward = 1e-3;  // voxels from the surface: where its piece is asked for

// The piece of all inside corners; kNone where there are several.
std::uint32_t onlyPiece(const Pieces& pieces, glm::ivec3 cell, const CellCorners& corners) {
  std::uint32_t one = Pieces::kNone;
  for (std::size_t i = 0; i < 8; ++i) {
    if (!(corners[i] >= 0.0)) continue;
    const std::uint32_t id = pieces.ofVoxel(cell + cornerStep(i));
    if (one != Pieces::kNone && id != one) return Pieces::kNone;
    one = id;
  }
  return one;
}

// Of the points of one piece: that nearest to their middle, with the area of all.
SurfacePatch patchOf(const std::vector<CellPoint>& points, const std::vector<std::uint32_t>& pieceOfPoint,
                     std::uint32_t piece) {
  SurfacePatch patch{{}, 0.0, piece};
  glm::dvec3 middle(0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (pieceOfPoint[i] == piece) {
      middle += points[i].area * points[i].local;
      patch.areaMm2 += points[i].area;
    }
  middle /= patch.areaMm2;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 away = points[i].local - middle;
    if (pieceOfPoint[i] != piece || !(glm::dot(away, away) < nearest)) continue;
    nearest = glm::dot(away, away);
    patch.voxel = points[i].local;
  }
  return patch;
}

}  // namespace

std::vector<SurfacePatch> patchesOfRow(const Pieces& pieces, const MinMaxBlocks& blocks, int blockY,
                                       int blockZ) {
  const CellMetric metric{glm::dmat3(pieces.grid().geometry().worldFromVoxel)};
  const double sign = pieces.inside() == scene::Inside::above ? 1.0 : -1.0;
  std::vector<SurfacePatch> patches;
  std::vector<CellPoint> points;
  std::vector<std::uint32_t> pieceOfPoint;
  const auto addCell = [&](glm::ivec3 cell, const CellCorners& corners) {
    points.clear();
    measureCell(corners, metric, &points);
    std::erase_if(points, [](const CellPoint& point) { return !(point.area > 0.0); });
    if (points.empty()) return;
    pieceOfPoint.assign(points.size(), onlyPiece(pieces, cell, corners));
    if (pieceOfPoint[0] == Pieces::kNone)
      for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3& gradient = points[i].gradient;
        const double length = glm::length(gradient);
        const glm::dvec3 inward = length > 0.0 ? gradient * (kInward / length) : glm::dvec3(0.0);
        const glm::dvec3 local = glm::clamp(points[i].local + inward, 0.0, 1.0);
        pieceOfPoint[i] = pieces.ofPoint(glm::dvec3(cell) + local);
      }
    for (const std::uint32_t piece : std::set(pieceOfPoint.begin(), pieceOfPoint.end())) {
      patches.push_back(patchOf(points, pieceOfPoint, piece));
      patches.back().voxel += glm::dvec3(cell);
    }
  };
  visitCrossedCells(pieces.grid(), blocks, pieces.isovalue(), sign, blockY, blockZ, addCell);
  return patches;
}

}  // namespace isolux::volume
