#include "volume/prepared/surface_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <tuple>

#include <tbb/combinable.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "volume/clip/surface_cut.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/prepared/surface_crossings.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kOutlineDirections = 96;
constexpr double kLeastGroup = 0.01;           // of all active blocks
constexpr std::size_t kSamplesWanted = 60000;  // about so many
constexpr std::size_t kOfBlock = 100;          // crossings, about

// Evenly over the sphere (Fibonacci), and the axes.
const std::vector<glm::dvec3>& outlineDirections() {
  static const std::vector<glm::dvec3> list = [] {
    std::vector<glm::dvec3> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::size_t i = 0; i < kOutlineDirections; ++i) {
      const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(kOutlineDirections);
      const double angle = static_cast<double>(i) * std::numbers::pi * (3.0 - std::sqrt(5.0));
      const double across = std::sqrt(1.0 - z * z);
      all.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
    }
    return all;
  }();
  return list;
}

// Clears the flags of groups (by faces, edges and corners) that are small.
void dropSpecks(const MinMaxBlocks& blocks, std::vector<std::uint8_t>& active) {
  const Extent3 extent{blocks.dims()};
  const auto all = static_cast<double>(std::ranges::count(active, 1));
  std::vector<std::uint8_t> seen(active.size(), 0);
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t first = 0; first < active.size(); ++first) {
    if (!active[first] || seen[first]) continue;
    std::vector<std::size_t>& group = groups.emplace_back(1, first);
    seen[first] = 1;
    for (std::size_t next = 0; next < group.size(); ++next) {
      const glm::ivec3 at = extent.at(group[next]);
      forEachIn(glm::max(at - 1, 0), glm::min(at + 2, extent.dims), [&](glm::ivec3 neighbour) {
        const std::size_t i = extent.index(neighbour);
        if (!active[i] || seen[i]) return;
        seen[i] = 1;
        group.push_back(i);
      });
    }
  }
  for (const std::vector<std::size_t>& group : groups)
    if (static_cast<double>(group.size()) < kLeastGroup * all)
      for (const std::size_t i : group) active[i] = 0;
}

// Farthest along one direction. Of points that are as far the one of the first voxel, whatever thread came
// first.
struct Extreme {
  double reach = -std::numeric_limits<double>::infinity();
  std::size_t voxel = 0;
  glm::dvec3 point{0.0};
  void take(const Extreme& other) {
    if (std::tie(other.reach, voxel) > std::tie(reach, other.voxel)) *this = other;
  }
};
using Extremes = std::vector<Extreme>;

// The gradient at a voxel, world, by differences of neighbours; of any length.
glm::dvec3 gradientAt(const Grid& grid, const glm::dmat3& worldOfGradient, glm::ivec3 at) {
  glm::dvec3 gradient(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 low = at, high = at;
    low[axis] = std::max(at[axis] - 1, 0);
    high[axis] = std::min(at[axis] + 1, grid.dims()[axis] - 1);
    if (high[axis] == low[axis]) continue;
    gradient[axis] = (grid.stored(high) - grid.stored(low)) / (high[axis] - low[axis]);
  }
  return worldOfGradient * gradient;
}

class OutlineSearch {
 public:
  OutlineSearch(const PreparedVolume& volume, const scene::Scene& resolved)
      : volume_(volume),
        grid_(volume.grid()),
        blocks_(*volume.blocks),
        inside_(resolved.isosurface.inside),
        cut_(resolved, grid_.geometry()),
        world_(grid_.geometry().worldFromVoxel),
        worldOfGradient_(glm::transpose(glm::inverse(glm::dmat3(world_)))),
        leastReach_(directions_.size(), -std::numeric_limits<double>::infinity()),
        extremes_([] { return Extremes(outlineDirections().size()); }) {
    const double half = 0.5 * blocks_.blockCells();
    for (int axis = 0; axis < 3; ++axis) radius_ += half * glm::length(glm::dvec3(world_[axis]));
  }

  void add(const Surface& surface, bool withSamples, base::Progress& progress) {
    std::vector<std::uint8_t> active;
    blocks_.activeBlocks(grid_.storedIsovalue(surface.isovalue), active);
    dropSpecks(blocks_, active);
    const auto count = static_cast<std::size_t>(std::ranges::count(active, 1));
    const std::size_t every = withSamples ? std::max<std::size_t>(1, count * kOfBlock / kSamplesWanted) : 0;
    samples_.resize(active.size());
    if (!surface.hidden && !cut_.cuts() && grid_.missingCount() == 0) findLeastReach(surface, active);
    parallelSteps(active.size(), progress, {}, [&](std::size_t block) {
      if (active[block]) addBlock(surface, block, every);
    });
  }

  SurfaceOutline result() {
    Extremes all(outlineDirections().size());
    extremes_.combine_each([&](const Extremes& part) {
      for (std::size_t i = 0; i < all.size(); ++i) all[i].take(part[i]);
    });
    SurfaceOutline outline;
    for (const Extreme& extreme : all)
      if (std::isfinite(extreme.reach)) outline.pointsMm.push_back(extreme.point);
    for (const std::vector<OutlineSample>& part : samples_)
      outline.samples.insert(outline.samples.end(), part.begin(), part.end());
    return outline;
  }

 private:
  // A block with voxels on both sides has a crossing: the surface reaches at least as far as its near side.
  void findLeastReach(const Surface& surface, const std::vector<std::uint8_t>& active) {
    const double isovalue = grid_.storedOfValue(surface.isovalue);
    tbb::combinable<std::vector<double>> parts([&] { return leastReach_; });
    parallelEach(static_cast<int>(active.size()), [&](int index) {
      const auto block = static_cast<std::size_t>(index);
      const double low = static_cast<double>(blocks_.minimum(block));
      if (!active[block] || !(low < isovalue) || static_cast<double>(blocks_.maximum(block)) < isovalue)
        return;
      std::vector<double>& least = parts.local();
      const glm::dvec3 centre = centreOf(block);
      for (std::size_t i = 0; i < least.size(); ++i)
        least[i] = std::max(least[i], glm::dot(directions_[i], centre) - radius_);
    });
    parts.combine_each([&](const std::vector<double>& part) {
      for (std::size_t i = 0; i < part.size(); ++i) leastReach_[i] = std::max(leastReach_[i], part[i]);
    });
  }

  glm::dvec3 centreOf(std::size_t block) const {
    const glm::ivec3 low = Extent3{blocks_.dims()}.at(block) * blocks_.blockCells();
    return world_ * glm::dvec4(glm::dvec3(low + low + blocks_.blockCells()) * 0.5, 1.0);
  }

  void addBlock(const Surface& surface, std::size_t block, std::size_t every) {
    Extremes& extremes = extremes_.local();
    const glm::dvec3 centre = centreOf(block);
    std::vector<std::size_t> open;  // directions in which this block may be the farthest
    for (std::size_t i = 0; i < extremes.size(); ++i)
      if (glm::dot(directions_[i], centre) + radius_ >= std::max(extremes[i].reach, leastReach_[i]))
        open.push_back(i);
    if (open.empty() && every == 0) return;
    const bool samplesAlone = open.empty() && !cut_.cuts();
    std::size_t found = block, asked = block;  // not the same of each block's
    const auto isWanted = [&] { return !samplesAlone || asked++ % every == 0; };
    eachCrossing(volume_, surface, inside_, block, isWanted, [&](glm::ivec3 voxel, glm::dvec3 crossing) {
      const glm::dvec3 point(world_ * glm::dvec4(crossing, 1.0));
      if (!cut_.keeps(surface.isovalue, crossing)) return;
      const std::size_t number = grid_.index(voxel);
      for (const std::size_t i : open) extremes[i].take({glm::dot(directions_[i], point), number, point});
      if (!samplesAlone && (every == 0 || found++ % every != 0)) return;
      const glm::dvec3 gradient = gradientAt(grid_, worldOfGradient_, voxel);
      const double length = glm::length(gradient);
      const bool rises = (inside_ == scene::Inside::above) == (grid_.slope() > 0.0);
      if (length > 0.0) samples_[block].push_back({point, gradient * ((rises ? -1.0 : 1.0) / length)});
    });
  }

  const PreparedVolume& volume_;
  const Grid& grid_;
  const MinMaxBlocks& blocks_;
  scene::Inside inside_;
  SurfaceCut cut_;
  glm::dmat4 world_;
  glm::dmat3 worldOfGradient_;
  double radius_ = 0.0;  // of a block, mm
  const std::vector<glm::dvec3>& directions_ = outlineDirections();
  std::vector<double> leastReach_;  // of the surface, in each direction
  tbb::combinable<Extremes> extremes_;
  std::vector<std::vector<OutlineSample>> samples_;  // of each block
};

}  // namespace

SurfaceOutline surfaceOutline(const PreparedVolume& volume, const scene::Scene& resolved, bool withSamples,
                              base::Progress& progress) {
  if (!volume.grid().isWhole()) return {};
  OutlineSearch search(volume, resolved);
  for (const Surface& surface : shownSurfaces(volume, resolved, progress))
    search.add(surface, withSamples, progress);
  return search.result();
}

}  // namespace isolux::volume
