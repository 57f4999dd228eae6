#include "volume/mesh/mesh_distance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/memory_budget.h"
#include "volume/mesh/triangle_tree.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

// The mesh in voxel coordinates.
TriangleMesh toVoxels(TriangleMesh mesh, const GridGeometry& geometry) {
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  for (glm::dvec3& p : mesh.points) p = glm::dvec3(voxelFromWorld * glm::dvec4(p, 1.0));
  return mesh;
}

// ---- Distance ----

constexpr int kBlock = 8;  // voxels per axis that share a first look

// |distance| in voxels, at most kDistanceBand, for the voxels of a block with this first voxel.
void measureBlock(const TriangleTree& tree, glm::ivec3 first, glm::ivec3 dims, float* values) {
  const glm::ivec3 last = glm::min(first + kBlock, dims) - 1;
  const glm::dvec3 middle = 0.5 * glm::dvec3(first + last);
  const double radius = 0.5 * glm::length(glm::dvec3(last - first));
  int nearest = -1;
  const bool near = tree.distance(middle, kDistanceBand + radius, nearest) < kDistanceBand + radius;
  forEachIn(first, last + 1, [&](glm::ivec3 voxel) {
    const double distance =
        near ? tree.distance(glm::dvec3(voxel), kDistanceBand, nearest) : double{kDistanceBand};
    values[Extent3{dims}.index(voxel)] = static_cast<float>(distance);
  });
}

std::vector<float> unsignedDistance(const TriangleMesh& voxelMesh, glm::ivec3 dims,
                                    base::Progress& progress) {
  progress.report(0.0, "measuring distances");
  constexpr std::size_t mostPieces = std::size_t{1} << 25;
  const std::size_t pieces = TriangleTree::piecesOf(voxelMesh, kBlock, mostPieces, progress);
  if (pieces >= mostPieces)
    throw base::Error(
        base::ErrorKind::memory, "", "source.mesh_voxels",
        "the mesh's surface has more than " + std::to_string(mostPieces) + " blocks of 8 voxels; lower it");
  const auto held = base::machineMemory().reserve(pieces * TriangleTree::kBytesOfPiece, "triangle blocks",
                                                  "a lower source.mesh_voxels needs less");
  const TriangleTree tree(voxelMesh, kBlock, progress);
  std::vector<float> values;
  resizeStoppably(values, Extent3{dims}.count(), progress);
  const Extent3 blocks{(dims + kBlock - 1) / kBlock};
  parallelSteps(blocks.count(), progress, {0.0, 1.0, "measuring distances"},
                [&](std::size_t i) { measureBlock(tree, blocks.at(i) * kBlock, dims, values.data()); });
  return values;
}

// ---- Sign: winding numbers along lines ----

// How the line along +y from p (its x is ignored) passes the side from a to b: +1 where it runs toward +z.
// The half-open rule and the order by z make it exactly -1 times that of the side from b to a.
int passes(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
  const bool upward = a.z <= p.z;
  if (upward == (b.z <= p.z)) return 0;
  const glm::dvec3 &low = upward ? a : b, &high = upward ? b : a;
  const double side = (high.y - low.y) * (p.z - low.z) - (p.y - low.y) * (high.z - low.z);
  if (side <= 0.0) return 0;
  return upward ? 1 : -1;
}

struct Crossing {
  double x;
  int step;  // of the winding number, going toward +x
};

// Where the x line through p crosses the triangle, if it does.
void addCrossing(const std::array<glm::dvec3, 3>& t, const glm::dvec3& p, std::vector<Crossing>& crossings) {
  const int winding = passes(t[0], t[1], p) + passes(t[1], t[2], p) + passes(t[2], t[0], p);
  if (winding == 0) return;
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const auto [low, high] = std::minmax({t[0].x, t[1].x, t[2].x});
  double x = t[0].x - (normal.y * (p.y - t[0].y) + normal.z * (p.z - t[0].z)) / normal.x;
  x = std::isfinite(x) ? std::clamp(x, low, high) : low;  // a triangle seen from its edge
  crossings.push_back({x, -winding});
}

// For each slice z, the triangles that reach its plane.
class Slices {
 public:
  Slices(const TriangleMesh& mesh, int slices) : starts_(static_cast<std::size_t>(slices) + 1) {
    const auto forEachSlice = [&](const Triangle& t, auto&& f) {
      const auto [low, high] = std::minmax({mesh.corner(t, 0).z, mesh.corner(t, 1).z, mesh.corner(t, 2).z});
      const double last = std::min(std::floor(high), slices - 1.0);
      for (double z = std::max(std::ceil(low), 0.0); z <= last; z += 1.0) f(static_cast<std::size_t>(z));
    };
    for (const Triangle& t : mesh.triangles) forEachSlice(t, [&](std::size_t z) { ++starts_[z + 1]; });
    for (std::size_t z = 1; z < starts_.size(); ++z) starts_[z] += starts_[z - 1];
    triangles_.resize(starts_.back());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      forEachSlice(mesh.triangles[i],
                   [&](std::size_t z) { triangles_[next[z]++] = static_cast<std::uint32_t>(i); });
  }
  std::span<const std::uint32_t> operator[](int z) const {
    const auto at = static_cast<std::size_t>(z);
    return {triangles_.data() + starts_[at], starts_[at + 1] - starts_[at]};
  }

 private:
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> triangles_;
};

// Makes the values of one x line negative where the winding number is 0.
void signLine(std::vector<Crossing>& crossings, float* values, int count) {
  std::ranges::sort(crossings, [](const auto& a, const auto& b) { return a.x < b.x; });
  int winding = 0;
  std::size_t next = 0;
  for (int x = 0; x < count; ++x) {
    for (; next < crossings.size() && crossings[next].x < x; ++next) winding += crossings[next].step;
    if (winding == 0) values[x] = -values[x];
  }
}

void signSlice(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, int z, glm::ivec3 dims,
               float* slice) {
  std::vector<std::vector<Crossing>> lines(static_cast<std::size_t>(dims.y));
  for (const std::uint32_t i : triangles) {
    const Triangle& t = mesh.triangles[i];
    const std::array corners{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const int last = static_cast<int>(std::min(std::floor(high), dims.y - 1.0));
    for (int y = static_cast<int>(std::max(std::ceil(low), 0.0)); y <= last; ++y)
      addCrossing(corners, glm::dvec3(0.0, y, z), lines[static_cast<std::size_t>(y)]);
  }
  for (int y = 0; y < dims.y; ++y)
    signLine(lines[static_cast<std::size_t>(y)], slice + static_cast<std::ptrdiff_t>(y) * dims.x, dims.x);
}

}  // namespace

BoxMm boundsOf(const TriangleMesh& mesh) {
  BoxMm box;
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) box.add(mesh.corner(t, i));
  return box;
}

GridGeometry gridAround(const BoxMm& box, int voxels) {
  assert(voxels >= 16);
  const int padding = 4 + voxels / 32;
  const glm::dvec3 extent = box.high - box.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const double spacing = longest / (voxels - 1 - 2 * padding);
  // The slack keeps the longest axis from gaining a voxel by rounding.
  const glm::ivec3 dims = glm::ivec3(glm::ceil(extent / spacing - 1e-6)) + 1 + 2 * padding;
  const glm::dvec3 origin = 0.5 * (box.low + box.high) - 0.5 * spacing * glm::dvec3(dims - 1);
  return GridGeometry::make(dims, glm::dvec3(spacing), origin);
}

bool hasCubicVoxels(const GridGeometry& geometry) {
  const glm::dmat3 linear(geometry.worldFromVoxel);
  const double scale = glm::dot(linear[0], linear[0]);
  const glm::dmat3 gram = glm::transpose(linear) * linear;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (std::abs(gram[i][j] - (i == j ? scale : 0.0)) > 1e-6 * scale) return false;
  return true;
}

Grid signedDistance(const TriangleMesh& closed, const GridGeometry& geometry, base::Progress& progress) {
  assert(hasCubicVoxels(geometry));
  const TriangleMesh mesh = toVoxels(closed, geometry);
  const glm::ivec3 dims = geometry.dims;
  std::vector<float> values = unsignedDistance(mesh, dims, progress);
  const Slices slices(mesh, dims.z);
  progress.throwIfStopped();
  const std::size_t sliceVoxels = geometry.extent().slice();
  const auto spacing = static_cast<float>(geometry.spacingMm().x);
  parallelEach(dims.z, [&](int z) {
    if (progress.stopRequested()) return;
    float* const slice = values.data() + sliceVoxels * static_cast<std::size_t>(z);
    signSlice(mesh, slices[z], z, dims, slice);
    for (std::size_t i = 0; i < sliceVoxels; ++i) slice[i] *= spacing;
  });
  progress.throwIfStopped();
  return {geometry, std::move(values), 1.0, 0.0, progress};
}

}  // namespace isolux::volume
