#include "volume/measure/surface_patches.h"

#include <algorithm>
#include <limits>

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
    const glm::ivec3 corner(static_cast<int>(i & 1), static_cast<int>(i >> 1 & 1), static_cast<int>(i >> 2));
    const std::uint32_t id = pieces.ofVoxel(cell + corner);
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

PatchFinder::PatchFinder(const Pieces& pieces, const MinMaxBlocks& blocks)
    : pieces_(pieces),
      blocks_(blocks),
      metric_(glm::dmat3(pieces.grid().geometry().worldFromVoxel)),
      sign_(pieces.inside() == scene::Inside::above ? 1.0 : -1.0) {}

void PatchFinder::appendRow(int blockY, int blockZ, std::vector<SurfacePatch>& patches) {
  visitCrossedCells(pieces_.grid(), blocks_, pieces_.isovalue(), sign_, blockY, blockZ,
                    [&](glm::ivec3 cell, const CellCorners& corners) { appendCell(cell, corners, patches); });
}

void PatchFinder::appendCell(glm::ivec3 cell, const CellCorners& corners,
                             std::vector<SurfacePatch>& patches) {
  points_.clear();
  measureCell(corners, metric_, &points_);
  std::erase_if(points_, [](const CellPoint& point) { return !(point.area > 0.0); });
  if (points_.empty()) return;
  pieceOfPoint_.assign(points_.size(), onlyPiece(pieces_, cell, corners));
  if (pieceOfPoint_[0] == Pieces::kNone)
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const glm::dvec3& gradient = points_[i].gradient;
      const double length = glm::length(gradient);
      const glm::dvec3 inward = length > 0.0 ? gradient * (kInward / length) : glm::dvec3(0.0);
      const glm::dvec3 local = glm::clamp(points_[i].local + inward, 0.0, 1.0);
      pieceOfPoint_[i] = pieces_.ofPoint(glm::dvec3(cell) + local);
    }
  std::vector<std::uint32_t> found = pieceOfPoint_;
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (const std::uint32_t piece : found) {
    patches.push_back(patchOf(points_, pieceOfPoint_, piece));
    patches.back().voxel += glm::dvec3(cell);
  }
}

}  // namespace isolux::volume
