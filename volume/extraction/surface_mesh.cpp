#include "volume/extraction/surface_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "volume/field/reconstruct.h"
#include "volume/mesh/mesh_edges.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/read/process/foreign.h"

namespace isolux::volume {

namespace {

constexpr double kApart = 1e-3, kSame = 1e-9, kNear = 1e-6;  // voxels; kSame: of mergeEqualPoints()

// How far inside a voxel is; missing and hidden voxels, and those beyond the border, are infinitely far
// outside.
double depthOf(const Grid& grid, const SurfaceMeshRequest& request, glm::ivec3 voxel) {
  constexpr double outside = -std::numeric_limits<double>::infinity();
  if (!grid.extent().contains(voxel)) return outside;
  const double value = grid.value(voxel);
  if (!std::isfinite(value) || (request.hidden != nullptr && request.hidden->at(voxel))) return outside;
  return request.inside == scene::Inside::above ? value - request.isovalue : request.isovalue - value;
}

// Flying edges look at sides only: they put a point in the middle of each edge of the grid that is crossed.
void fillSamples(const Grid& grid, const SurfaceMeshRequest& request, int pad, std::span<float> samples) {
  const Extent3 extent{grid.dims() + 2 * pad};
  parallelEach(extent.rows(), [&](std::size_t row) {
    for (glm::ivec3 at = extent.firstOfRow(row); at.x < extent.dims.x; ++at.x)
      samples[extent.index(at)] = depthOf(grid, request, at - pad) >= 0.0 ? 1.0f : -1.0f;
  });
}

// The point of an isosurface that lies straight below or above a point near it.
class SurfaceProjection {
 public:
  // coefficients: of cubic_interpolating, else null. isovalue: data units. Keeps references.
  SurfaceProjection(const Grid& grid, scene::Field field, const Coefficients* coefficients, double isovalue)
      : grid_(grid), field_(field), coefficients_(coefficients), isovalue_(isovalue) {
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(grid.geometry().worldFromVoxel));
    metric_ = inverse * glm::transpose(inverse);
  }

  // By Newton's steps along the gradient of the world, to 1e-9 voxel; voxel coordinates. Nothing where they
  // do not come to the surface within two voxels.
  std::optional<glm::dvec3> of(const glm::dvec3& voxel) const {
    constexpr int steps = 24;
    constexpr double near = 1e-9, farthest = 2.0, longest = 0.5;  // voxels
    const glm::dvec3 last(grid_.dims() - 1);
    glm::dvec3 point = voxel;
    for (int i = 0; i < steps; ++i) {
      const FieldSample sample = sampleField(grid_, field_, coefficients_, point);
      const glm::dvec3 across = metric_ * sample.gradient;
      const double slope = glm::dot(sample.gradient, across);
      if (!(slope > 0.0)) return std::nullopt;  // NaN too
      glm::dvec3 step = (isovalue_ - sample.value) / slope * across;
      if (const double length = glm::length(step); length > longest) step *= longest / length;
      point = glm::clamp(point + step, glm::dvec3(0.0), last);
      if (glm::distance(point, voxel) > farthest) return std::nullopt;
      if (glm::length(step) < near) return point;
    }
    return std::nullopt;
  }

 private:
  const Grid& grid_;
  scene::Field field_;
  const Coefficients* coefficients_;
  double isovalue_;
  glm::dmat3 metric_;  // A^-1 A^-T: turns a gradient of voxel space into the direction across in the world
};

// A crossed edge of the grid, from its voxel inside to the one outside.
struct CrossedEdge {
  glm::dvec3 inside, outside;
  double share = 0.0;  // of the way, to where f is the isovalue
  bool atVoxel = false;

  // `middle`: of the edge.
  CrossedEdge(const Grid& grid, const SurfaceMeshRequest& request, const glm::dvec3& middle)
      : inside(glm::floor(middle)), outside(glm::ceil(middle)) {
    double depth = depthOf(grid, request, glm::ivec3(inside)),
           other = depthOf(grid, request, glm::ivec3(outside));
    if (!(depth >= 0.0)) {
      std::swap(inside, outside);
      std::swap(depth, other);
    }
    share = depth / (depth - other);
    if (share > kSame) return;
    share = 0.0;
    atVoxel = std::isfinite(other);
  }
  glm::dvec3 point() const { return inside + share * (outside - inside); }
};

// Whether triangles about a point, of each the corner behind it and the one before, are one fan, open or
// closed.
bool isOneFan(const std::vector<std::pair<int, int>>& sides) {
  std::map<int, int> next;
  std::set<int> ends;
  for (const auto& [from, to] : sides)
    if (!next.emplace(from, to).second || !ends.insert(to).second) return false;
  int at = sides.front().first;
  for (const auto& [from, to] : sides)
    if (!ends.contains(from)) at = from;
  std::size_t count = 0;
  for (auto found = next.find(at); found != next.end() && count < sides.size();
       found = next.find(found->second))
    ++count;
  return count == sides.size();
}

// On which planes of the border a point lies, a bit each.
int borderOf(const Grid& grid, const glm::dvec3& point) {
  int bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] <= 0.0) bits |= 1 << (2 * axis);
    if (point[axis] >= grid.dims()[axis] - 1) bits |= 2 << (2 * axis);
  }
  return bits;
}

class Maker {
 public:
  Maker(const Grid& grid, const SurfaceMeshRequest& request)
      : grid_(grid), request_(request), foot_(grid, request.field, request.coefficients, request.isovalue) {}

  SurfaceMesh make(base::Progress& progress) {
    extract(progress);
    ontoSurface();
    mergeCorners(progress);
    do {
      progress.throwIfStopped();
      measure();
    } while (refine());
    return finished();
  }

 private:
  void extract(base::Progress& progress) {
    const int pad = request_.closed ? 1 : 0;
    mesh_ = contour(
        grid_.dims() + 2 * pad, [&](std::span<float> samples) { fillSamples(grid_, request_, pad, samples); },
        request_.budgetBytes, progress);
    for (glm::dvec3& point : mesh_.points) point -= static_cast<double>(pad);
    if (grid_.missingCount() > 0)
      std::erase_if(mesh_.triangles, [&](const Triangle& t) {
        return grid_.cellHasMissing(grid_.geometry().cellOf(middle(t)));
      });
  }

  glm::dvec3 middle(const Triangle& t) const {
    return (mesh_.corner(t, 0) + mesh_.corner(t, 1) + mesh_.corner(t, 2)) / 3.0;
  }

  void ontoSurface() {
    const glm::dvec3 last(grid_.dims() - 1);
    const bool throughVoxels = request_.field != scene::Field::cubic;
    capping_.assign(mesh_.points.size(), 0);
    std::vector<char> astray(mesh_.points.size(), 0), atVoxel(mesh_.points.size(), 0);
    const std::vector<glm::dvec3> middles = mesh_.points;
    parallelEach(mesh_.points.size(), [&](std::size_t i) {
      glm::dvec3& point = mesh_.points[i];
      if (point != glm::clamp(point, glm::dvec3(0.0), last)) {
        point = glm::clamp(point, glm::dvec3(0.0), last);
        capping_[i] = 1;
        return;
      }
      const CrossedEdge edge(grid_, request_, point);
      point = edge.point();
      atVoxel[i] = edge.atVoxel && throughVoxels ? 1 : 0;
      if (request_.field == scene::Field::trilinear) return;
      if (const auto moved = foot_.of(point))
        point = *moved;
      else
        astray[i] = 1;
    });
    astray_ = static_cast<std::size_t>(std::ranges::count(astray, 1));
    for (std::size_t i = 0; i < middles.size(); ++i)
      if (atVoxel[i])
        atVoxels_[voxelAt(mesh_.points[i])].push_back({i, 2.0 * (middles[i] - mesh_.points[i])});
  }

  std::size_t voxelAt(const glm::dvec3& point) const { return grid_.index(glm::ivec3(glm::round(point))); }

  static bool isVoxel(const glm::dvec3& point) { return glm::distance(point, glm::round(point)) <= kNear; }

  // Points at the same place become one, triangles without three corners go. Where that joins sheets at a
  // voxel whose value is the isovalue, the mesh of it stays apart: its points are moved a little toward their
  // edges' outer ends.
  void mergeCorners(const base::Progress& progress) {
    if (atVoxels_.empty()) return mergeEqualPoints(mesh_, capping_, progress);
    TriangleMesh apart = mesh_;
    const std::vector<char> capping = capping_;
    for (;;) {
      mergeEqualPoints(mesh_, capping_, progress);
      bool any = false;
      for (const std::size_t voxel : joinedVoxels()) {
        for (const auto& [point, outward] : atVoxels_[voxel]) {
          apart.points[point] += kApart * outward;
          apartMm_ = std::max(apartMm_, kApart * lengthMm(outward));
        }
        atVoxels_.erase(voxel);
        any = true;
      }
      if (!any) {
        if (dropFolded()) mergeEqualPoints(mesh_, capping_, progress);
        return;
      }
      mesh_ = apart;
      capping_ = capping;
    }
  }

  // Two triangles on the same three voxels, the one turned over: a piece without volume, which goes. False:
  // there was none.
  bool dropFolded() {
    std::map<std::array<int, 3>, std::size_t> first;
    std::vector<char> folded(mesh_.triangles.size(), 0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& triangle = mesh_.triangles[t];
      std::array<int, 3> corners{triangle[0], triangle[1], triangle[2]};
      if (!std::ranges::all_of(corners,
                               [&](int c) { return isVoxel(mesh_.points[static_cast<std::size_t>(c)]); }))
        continue;
      std::ranges::sort(corners);
      const auto [place, isNew] = first.emplace(corners, t);
      if (isNew) continue;
      folded[t] = folded[place->second] = 1;
      first.erase(place);
    }
    std::size_t t = 0;
    return std::erase_if(mesh_.triangles, [&](const Triangle&) { return folded[t++] != 0; }) > 0;
  }

  // Of atVoxels_, those at which several sheets meet.
  std::vector<std::size_t> joinedVoxels() const {
    std::unordered_map<std::size_t, std::vector<std::pair<int, int>>> fans;
    for (const Triangle& t : mesh_.triangles)
      for (int i = 0; i < 3; ++i) {
        const glm::dvec3& point = mesh_.corner(t, i);
        if (!isVoxel(point) || !atVoxels_.contains(voxelAt(point))) continue;
        fans[voxelAt(point)].emplace_back(t[(i + 1) % 3], t[(i + 2) % 3]);
      }
    std::vector<std::size_t> joined;
    for (const auto& [voxel, sides] : fans)
      if (!isOneFan(sides)) joined.push_back(voxel);
    return joined;
  }

  bool isCap(const Triangle& t) const {
    int common = ~0;
    for (int i = 0; i < 3; ++i) common &= borderOf(grid_, mesh_.corner(t, i));
    return common != 0;
  }

  // Middles of edges and triangles, where the surface is nearest to them, and how far.
  void measure() {
    edges_ = MeshEdges(mesh_.triangles);
    std::vector<char> ofSurface(edges_.count(), 0), cap(mesh_.triangles.size(), 0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      cap[t] = isCap(mesh_.triangles[t]) ? 1 : 0;
      for (int side = 0; side < 3 && !cap[t]; ++side) ofSurface[edges_.of(t, side)] = 1;
    }
    feet_.assign(edges_.count(), {});
    parallelEach(edges_.count(), [&](std::size_t e) {
      const auto [a, b] = edges_.ends(e);
      const glm::dvec3 corners[] = {mesh_.points[a], mesh_.points[b]};
      if (ofSurface[e] && !capping_[a] && !capping_[b])
        feet_[e] = footOf(0.5 * (corners[0] + corners[1]), corners);
    });
    middles_.assign(mesh_.triangles.size(), {});
    parallelEach(mesh_.triangles.size(), [&](std::size_t i) {
      const Triangle& t = mesh_.triangles[i];
      const glm::dvec3 corners[] = {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
      if (!cap[i]) middles_[i] = footOf(middle(t), corners);
    });
  }

  struct Foot {
    std::optional<glm::dvec3> point;  // nothing: the surface is not found as near as the corners are
    double distanceMm = 0.0;          // then that of the nearest corner
  };
  Foot footOf(const glm::dvec3& point, std::span<const glm::dvec3> corners) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& corner : corners) nearest = std::min(nearest, lengthMm(corner - point));
    const auto foot = foot_.of(point);
    const double distance = foot ? lengthMm(*foot - point) : nearest;
    if (!foot || distance >= nearest) return {std::nullopt, nearest};
    return {foot, distance};
  }
  double lengthMm(const glm::dvec3& voxels) const {
    return glm::length(glm::dmat3(grid_.geometry().worldFromVoxel) * voxels);
  }

  // False when every triangle is near enough.
  bool refine() {
    if (!(request_.toleranceMm > 0.0) || ++rounds_ > kMostRounds) return false;
    std::vector<int> split(edges_.count(), -1);
    const auto splitAt = [&](std::size_t edge) {
      // Without a foot nearby it would lead to another part of the surface.
      if (split[edge] >= 0 || !feet_[edge].point) return;
      const auto [a, b] = edges_.ends(edge);
      split[edge] = static_cast<int>(mesh_.points.size());
      mesh_.points.push_back(*feet_[edge].point);
      capping_.push_back(capping_[a] && capping_[b] ? 1 : 0);
    };
    for (std::size_t e = 0; e < edges_.count(); ++e)
      if (feet_[e].distanceMm > request_.toleranceMm) splitAt(e);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (middles_[t].distanceMm > request_.toleranceMm)
        if (const auto edge = longestEdge(t)) splitAt(*edge);
    if (std::ranges::all_of(split, [](int s) { return s < 0; })) return false;
    mesh_.triangles = splitTriangles(mesh_, edges_, split);
    return true;
  }

  // Of those that can be split.
  std::optional<std::size_t> longestEdge(std::size_t t) const {
    std::optional<std::size_t> longest;
    double most = 0.0;
    for (int side = 0; side < 3; ++side) {
      const std::size_t edge = edges_.of(t, side);
      const auto [a, b] = edges_.ends(edge);
      const double length = lengthMm(mesh_.points[a] - mesh_.points[b]);
      if (feet_[edge].point && length > most) most = length, longest = edge;
    }
    return longest;
  }

  SurfaceMesh finished() {
    SurfaceMesh result;
    // Where all is inside there is no surface, only the border.
    if (std::ranges::all_of(mesh_.triangles, [&](const Triangle& t) { return isCap(t); })) return result;
    result.largestDistanceMm = apartMm_;
    result.toleranceMm = request_.toleranceMm;
    const auto look = [&](const Foot& foot, const auto& place) {
      if (request_.toleranceMm > 0.0 && foot.distanceMm > request_.toleranceMm) ++result.beyond;
      if (foot.distanceMm <= result.largestDistanceMm) return;
      result.largestDistanceMm = foot.distanceMm;
      result.farthest = place();
    };
    for (std::size_t e = 0; e < feet_.size(); ++e)
      look(feet_[e], [&] {
        const auto [a, b] = edges_.ends(e);
        return 0.5 * (mesh_.points[a] + mesh_.points[b]);
      });
    for (std::size_t t = 0; t < middles_.size(); ++t)
      look(middles_[t], [&] { return middle(mesh_.triangles[t]); });
    result.astray = astray_;
    result.openEdges = edges_.open();
    const glm::dmat4& world = grid_.geometry().worldFromVoxel;
    orient();
    result.farthest = glm::dvec3(world * glm::dvec4(result.farthest, 1.0));
    for (glm::dvec3& point : mesh_.points) point = glm::dvec3(world * glm::dvec4(point, 1.0));
    result.mesh = std::move(mesh_);
    return result;
  }

  // Flying edges turn all triangles so that their normals look down the gradient of the samples, out of the
  // inside.
  void orient() {
    if (glm::determinant(glm::dmat3(grid_.geometry().worldFromVoxel)) > 0.0) return;
    for (Triangle& t : mesh_.triangles) std::swap(t[1], t[2]);
  }

  static constexpr int kMostRounds = 8;

  const Grid& grid_;
  const SurfaceMeshRequest& request_;
  SurfaceProjection foot_;
  TriangleMesh mesh_;          // voxel coordinates
  std::vector<char> capping_;  // of each point: it closes the surface at the border
  std::size_t astray_ = 0;
  struct AtVoxel {
    std::size_t point;
    glm::dvec3 outward;  // along its edge of the grid, one voxel
  };
  std::unordered_map<std::size_t, std::vector<AtVoxel>> atVoxels_;  // by voxels whose value is the isovalue
  double apartMm_ = 0.0;  // how far points were moved off their voxels
  MeshEdges edges_;
  std::vector<Foot> feet_, middles_;  // of the edges' and of the triangles' middles
  int rounds_ = 0;
};

}  // namespace

SurfaceMesh surfaceMesh(const Grid& grid, const SurfaceMeshRequest& request, base::Progress& progress) {
  return Maker(grid, request).make(progress);
}

std::size_t estimatedTriangles(const Grid& grid, const MinMaxBlocks& blocks, double isovalue) {
  constexpr std::size_t enough = 500;  // blocks
  constexpr double trianglesPerCell =
      2;  // of a surface much larger than a cell: closed meshes have two a point
  if (!grid.isWhole()) return 0;
  const double stored = grid.storedOfValue(isovalue);
  std::vector<std::uint8_t> flags;
  const std::size_t active = blocks.activeBlocks(static_cast<float>(stored), flags);
  const std::size_t stride = std::max<std::size_t>(1, active / enough);
  const glm::ivec3 cells = grid.dims() - 1;
  std::size_t met = 0, looked = 0, crossed = 0;
  const auto cross = [&](glm::ivec3 cell) {
    int above = 0;
    for (int i = 0; i < 8; ++i) above += grid.stored(cell + cornerStep(i)) >= stored ? 1 : 0;
    return above > 0 && above < 8;
  };
  for (std::size_t block = 0; block < flags.size(); ++block) {
    if (flags[block] == 0 || met++ % stride != 0) continue;
    ++looked;
    const glm::ivec3 low = Extent3{blocks.dims()}.at(block) * blocks.blockCells();
    forEachIn(low, glm::min(low + blocks.blockCells(), cells),
              [&](glm::ivec3 cell) { crossed += cross(cell) ? 1 : 0; });
  }
  if (looked == 0) return 0;
  return static_cast<std::size_t>(trianglesPerCell * static_cast<double>(crossed) *
                                  static_cast<double>(active) / static_cast<double>(looked));
}

}  // namespace isolux::volume
