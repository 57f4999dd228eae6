#include "tests/support/flooded_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace isolux::test {

namespace {

constexpr std::uint32_t kOutside = 0xffffffffu;

double interpolated(const std::array<double, 8>& f, glm::dvec3 p) {
  double sum = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
    sum += f[corner] * ((corner & 1) ? p.x : 1.0 - p.x) * ((corner & 2) ? p.y : 1.0 - p.y) *
           ((corner & 4) ? p.z : 1.0 - p.z);
  return sum;
}

bool within(glm::ivec3 p, glm::ivec3 dims) {
  return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < dims.x && p.y < dims.y && p.z < dims.z;
}

glm::ivec3 cornerOf(int corner) {
  return {corner & 1, corner >> 1 & 1, corner >> 2};
}

class Flood {
 public:
  Flood(const volume::Grid& grid, double isovalue, scene::Inside inside, bool inCells)
      : grid_(grid),
        level_(static_cast<float>(isovalue)),
        sign_(inside == scene::Inside::above ? 1.0 : -1.0),
        inCells_(inCells) {
    result_.label.assign(grid.geometry().voxelCount(), kOutside);
  }

  FloodedPieces run() {
    const glm::ivec3 n = grid_.dims();
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x) {
          const glm::ivec3 start(x, y, z);
          if (label(start) != kOutside || !(depth(start) >= 0.0)) continue;
          result_.voxels.push_back(0);
          visit(start);
          spread();
        }
    return std::move(result_);
  }

 private:
  std::uint32_t& label(glm::ivec3 p) { return result_.label[grid_.index(p.x, p.y, p.z)]; }
  double depth(glm::ivec3 p) const { return sign_ * (grid_.value(p.x, p.y, p.z) - level_); }

  void visit(glm::ivec3 p) {
    if (!within(p, grid_.dims()) || label(p) != kOutside || !(depth(p) >= 0.0)) return;
    label(p) = static_cast<std::uint32_t>(result_.voxels.size() - 1);
    ++result_.voxels.back();
    stack_.push_back(p);
  }

  void spread() {
    while (!stack_.empty()) {
      const glm::ivec3 p = stack_.back();
      stack_.pop_back();
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          glm::ivec3 next = p;
          next[axis] += step;
          visit(next);
        }
      for (int corner = 0; inCells_ && corner < 8; ++corner) spreadInCell(p - cornerOf(corner), corner);
    }
  }

  // Along an axis of one voxel cells have that voxel at both ends.
  glm::ivec3 voxelOf(glm::ivec3 cell, int corner) const {
    glm::ivec3 at = cell + cornerOf(corner);
    for (int axis = 0; axis < 3; ++axis)
      if (grid_.dims()[axis] == 1) at[axis] = 0;
    return at;
  }

  void spreadInCell(glm::ivec3 cell, int from) {
    if (!within(cell, glm::max(grid_.dims() - 1, 1))) return;
    std::array<double, 8> values;
    for (int corner = 0; corner < 8; ++corner) {
      const double value = depth(voxelOf(cell, corner));
      if (std::isnan(value)) return;
      values[static_cast<std::size_t>(corner)] = value;
    }
    constexpr int n = 25;
    double least = 1e300, steepest = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      least = std::min(least, std::abs(values[corner]));
      for (const std::size_t axis : {1u, 2u, 4u})
        steepest = std::max(steepest, std::abs(values[corner] - values[corner ^ axis]));
    }
    const auto joined = floodedCorners(values, n, 0.0);
    const double margin = std::min(0.999 * least, 1.5 * steepest / (n - 1));
    if (joined != floodedCorners(values, n, -margin)) ++result_.undecidedCells;
    for (int corner = 0; corner < 8; ++corner)
      if (joined[static_cast<std::size_t>(corner)] < 8 &&
          joined[static_cast<std::size_t>(corner)] == joined[static_cast<std::size_t>(from)])
        visit(voxelOf(cell, corner));
  }

  const volume::Grid& grid_;
  double level_, sign_;
  bool inCells_;
  FloodedPieces result_;
  std::vector<glm::ivec3> stack_;
};

}  // namespace

std::array<int, 8> floodedCorners(const std::array<double, 8>& values, int n, double level) {
  const auto index = [n](glm::ivec3 p) { return static_cast<std::size_t>((p.z * n + p.y) * n + p.x); };
  std::vector<int> label(index(glm::ivec3(n - 1)) + 1, 8);
  std::vector<glm::ivec3> stack;
  std::array<int, 8> result;
  for (int corner = 0; corner < 8; ++corner) {
    const auto visit = [&](glm::ivec3 p) {
      if (!within(p, glm::ivec3(n)) || label[index(p)] < 8) return;
      if (interpolated(values, glm::dvec3(p) / double(n - 1)) < level) return;
      label[index(p)] = corner;
      stack.push_back(p);
    };
    const glm::ivec3 start = cornerOf(corner) * (n - 1);
    visit(start);
    while (!stack.empty()) {
      const glm::ivec3 p = stack.back();
      stack.pop_back();
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          glm::ivec3 next = p;
          next[axis] += step;
          visit(next);
        }
    }
    result[static_cast<std::size_t>(corner)] = label[index(start)];
  }
  return result;
}

FloodedPieces floodedPieces(const volume::Grid& grid, double isovalue, scene::Inside inside, bool inCells) {
  return Flood(grid, isovalue, inside, inCells).run();
}

}  // namespace isolux::test
