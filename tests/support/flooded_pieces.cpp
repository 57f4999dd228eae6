#include "tests/support/flooded_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace isolux::test {

namespace {

constexpr std::uint32_t kOutside = 0xffffffffu;

bool within(glm::ivec3 p, glm::ivec3 dims) {
  return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < dims.x && p.y < dims.y && p.z < dims.z;
}

glm::ivec3 cornerOf(int corner) {
  return {corner & 1, corner >> 1 & 1, corner >> 2};
}

template <class Visit>
void eachNeighbour(glm::ivec3 p, const Visit& visit) {
  for (int axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      glm::ivec3 next = p;
      next[axis] += step;
      visit(next);
    }
}

class CellLattice {
 public:
  CellLattice(const std::array<double, 8>& f, int n) : n_(n) {
    samples_.reserve(index(glm::ivec3(n - 1)) + 1);
    const auto part = [n](int i) { return static_cast<double>(i) / (n - 1); };
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y) {
        const double w = part(z), v = part(y);
        const auto atEnd = [&](std::size_t x) {
          return (1.0 - w) * ((1.0 - v) * f[x] + v * f[x + 2]) + w * ((1.0 - v) * f[x + 4] + v * f[x + 6]);
        };
        const double begin = atEnd(0), end = atEnd(1);
        for (int x = 0; x < n; ++x) samples_.push_back((1.0 - part(x)) * begin + part(x) * end);
      }
  }

  // The corners that samples >= level join.
  std::array<int, 8> flood(double level) const {
    std::vector<int> label(samples_.size(), 8);
    std::vector<glm::ivec3> stack;
    std::array<int, 8> result;
    for (int corner = 0; corner < 8; ++corner) {
      const auto visit = [&](glm::ivec3 p) {
        if (!within(p, glm::ivec3(n_)) || label[index(p)] < 8 || samples_[index(p)] < level) return;
        label[index(p)] = corner;
        stack.push_back(p);
      };
      const glm::ivec3 start = cornerOf(corner) * (n_ - 1);
      visit(start);
      while (!stack.empty()) {
        const glm::ivec3 p = stack.back();
        stack.pop_back();
        eachNeighbour(p, visit);
      }
      result[static_cast<std::size_t>(corner)] = label[index(start)];
    }
    return result;
  }

 private:
  std::size_t index(glm::ivec3 p) const { return static_cast<std::size_t>((p.z * n_ + p.y) * n_ + p.x); }
  int n_;
  std::vector<double> samples_;
};

class Flood {
 public:
  Flood(const volume::Grid& grid, double isovalue, scene::Inside inside)
      : grid_(grid), isovalue_(isovalue), sign_(inside == scene::Inside::above ? 1.0 : -1.0) {
    alongAxes_.label.assign(grid.geometry().voxelCount(), kOutside);
  }

  FloodedBounds run() {
    eachWithin(grid_.dims(), [&](glm::ivec3 start) {
      if (label(start) != kOutside || !(depth(start) >= 0.0)) return;
      alongAxes_.voxels.push_back(0);
      visit(start);
      spread();
    });
    joined_.resize(alongAxes_.voxels.size());
    possible_.resize(alongAxes_.voxels.size());
    eachWithin(glm::max(grid_.dims() - 1, 1), [&](glm::ivec3 cell) { lookInto(cell); });
    return {merged(joined_), merged(possible_)};
  }

 private:
  template <class Visit>
  static void eachWithin(glm::ivec3 n, const Visit& visit) {
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x) visit(glm::ivec3(x, y, z));
  }

  std::uint32_t& label(glm::ivec3 p) { return alongAxes_.label[grid_.index(p.x, p.y, p.z)]; }
  double depth(glm::ivec3 p) const { return sign_ * (grid_.value(p.x, p.y, p.z) - isovalue_); }

  void visit(glm::ivec3 p) {
    if (!within(p, grid_.dims()) || label(p) != kOutside || !(depth(p) >= 0.0)) return;
    label(p) = static_cast<std::uint32_t>(alongAxes_.voxels.size() - 1);
    ++alongAxes_.voxels.back();
    stack_.push_back(p);
  }

  void spread() {
    while (!stack_.empty()) {
      const glm::ivec3 p = stack_.back();
      stack_.pop_back();
      eachNeighbour(p, [&](glm::ivec3 next) { visit(next); });
    }
  }

  // Along an axis of one voxel cells have that voxel at both ends.
  glm::ivec3 voxelOf(glm::ivec3 cell, int corner) const {
    return glm::min(cell + cornerOf(corner), grid_.dims() - 1);
  }

  void lookInto(glm::ivec3 cell) {
    std::array<double, 8> values;
    std::array<std::uint32_t, 8> labels;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      values[corner] = depth(voxelOf(cell, static_cast<int>(corner)));
      labels[corner] = label(voxelOf(cell, static_cast<int>(corner)));
      if (std::isnan(values[corner])) return;
    }
    const auto first =
        std::find_if(labels.begin(), labels.end(), [](std::uint32_t l) { return l != kOutside; });
    if (std::all_of(labels.begin(), labels.end(),
                    [&](std::uint32_t l) { return l == kOutside || l == *first; }))
      return;
    const FloodedCorners corners = floodedCorners(values);
    for (std::size_t corner = 0; corner < 8; ++corner) {
      if (labels[corner] == kOutside) continue;
      link(joined_, labels[corner], labels[static_cast<std::size_t>(corners.joined[corner])]);
      link(possible_, labels[corner], labels[static_cast<std::size_t>(corners.possible[corner])]);
    }
  }

  // Of each piece along axes those that it touches in a cell.
  using Links = std::vector<std::vector<std::uint32_t>>;
  static void link(Links& links, std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    links[a].push_back(b);
    links[b].push_back(a);
  }

  // A flood from piece to piece.
  FloodedPieces merged(const Links& links) const {
    FloodedPieces result;
    std::vector<std::uint32_t> number(links.size(), kOutside), stack;
    for (std::uint32_t start = 0; start < number.size(); ++start) {
      if (number[start] != kOutside) continue;
      result.voxels.push_back(0);
      stack.push_back(start);
      while (!stack.empty()) {
        const std::uint32_t piece = stack.back();
        stack.pop_back();
        if (number[piece] != kOutside) continue;
        number[piece] = static_cast<std::uint32_t>(result.voxels.size() - 1);
        result.voxels.back() += alongAxes_.voxels[piece];
        stack.insert(stack.end(), links[piece].begin(), links[piece].end());
      }
    }
    for (const std::uint32_t label : alongAxes_.label)
      result.label.push_back(label == kOutside ? kOutside : number[label]);
    return result;
  }

  const volume::Grid& grid_;
  double isovalue_, sign_;
  FloodedPieces alongAxes_;
  Links joined_, possible_;
  std::vector<glm::ivec3> stack_;
};

}  // namespace

FloodedCorners floodedCorners(const std::array<double, 8>& values) {
  double steepest = 0.0, least = 1e300;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    least = std::min(least, std::abs(values[corner]));
    for (const std::size_t axis : {1u, 2u, 4u})
      steepest = std::max(steepest, std::abs(values[corner] - values[corner ^ axis]));
  }
  FloodedCorners corners;
  for (int n = 9; n <= 33; n = 2 * n - 1) {
    const CellLattice lattice(values, n);
    corners.joined = lattice.flood(0.0);
    corners.possible = lattice.flood(-std::min(0.999 * least, 1.5 * steepest / (n - 1)));
    if (corners.possible == corners.joined) break;
  }
  return corners;
}

FloodedBounds floodedPieces(const volume::Grid& grid, double isovalue, scene::Inside inside) {
  return Flood(grid, isovalue, inside).run();
}

}  // namespace isolux::test
