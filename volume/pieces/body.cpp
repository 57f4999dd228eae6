#include "volume/pieces/body.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "volume/grid.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/pieces/pieces.h"
#include "volume/pieces/running_sums.h"
#include "volume/visible/inside_level.h"

namespace isolux::volume {

namespace {

constexpr double kNodesAlong = 128.0;
constexpr double kThickMm = 5.0, kThickPart = 0.1;  // radius of the balls that fit into what is thick
constexpr double kDeepPart = 0.25;                  // of the greatest depth: parts of the body
constexpr int kEnclosed = 5;                        // directions of six
constexpr float kFar = 1e18f;                       // mm^2

using Flags = std::vector<std::uint8_t>;

struct Nodes {
  glm::ivec3 dims;
  glm::dvec3 spacingMm;

  std::size_t count() const { return Extent3{dims}.count(); }
  std::size_t stride(int axis) const {
    std::size_t stride = 1;
    for (int a = 0; a < axis; ++a) stride *= static_cast<std::size_t>(dims[a]);
    return stride;
  }
  // Calls work(first, stride, length) for each line along the axis, on all cores.
  template <class Work>
  void alongLines(int axis, const Work& work) const {
    const auto length = static_cast<std::size_t>(dims[axis]);
    const std::size_t along = stride(axis);
    parallelEach(count() / length, [&](std::size_t line) {
      work(line / along * along * length + line % along, along, length);
    });
  }
};

Flags solidOf(const Nodes& nodes, Flags above) {
  Flags seen(above.size());
  for (int axis = 0; axis < 3; ++axis)
    nodes.alongLines(axis, [&](std::size_t first, std::size_t stride, std::size_t length) {
      for (const bool back : {false, true}) {
        std::uint8_t met = 0;
        for (std::size_t i = 0; i < length; ++i) {
          const std::size_t node = first + (back ? length - 1 - i : i) * stride;
          seen[node] = static_cast<std::uint8_t>(seen[node] + met);
          met |= above[node];
        }
      }
    });
  for (std::size_t i = 0; i < above.size(); ++i)
    if (seen[i] >= kEnclosed) above[i] = 1;
  return above;
}

// Replaces d(i) along a line by the lower envelope of the parabolas d(i) + (x - i)^2: Felzenszwalb and
// Huttenlocher 2012.
void replaceByEnvelope(float* line, std::size_t stride, std::size_t length, double spacing) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> values(length), from(length + 1);
  std::vector<std::size_t> of(length);
  std::size_t last = 0;
  from[0] = -infinity;
  from[1] = infinity;
  for (std::size_t i = 0; i < length; ++i) values[i] = static_cast<double>(line[i * stride]);
  const auto place = [&](std::size_t i) { return static_cast<double>(i) * spacing; };
  for (std::size_t i = 1; i < length; ++i) {
    const auto meets = [&] {
      const std::size_t k = of[last];
      return 0.5 * ((values[i] - values[k]) / (place(i) - place(k)) + place(i) + place(k));
    };
    double at = meets();
    while (at <= from[last]) {
      --last;
      at = meets();
    }
    of[++last] = i;
    from[last] = at;
    from[last + 1] = infinity;
  }
  for (std::size_t i = 0, k = 0; i < length; ++i) {
    while (from[k + 1] < place(i)) ++k;
    const double apart = place(i) - place(of[k]);
    line[i * stride] = static_cast<float>(std::min(values[of[k]] + apart * apart, double{kFar}));
  }
}

// From each node to the nearest one of `to`, mm^2; kFar where there is none.
std::vector<float> squaredDistances(const Nodes& nodes, const Flags& nearest, std::uint8_t to) {
  std::vector<float> result(nearest.size());
  for (std::size_t i = 0; i < nearest.size(); ++i) result[i] = nearest[i] == to ? 0.0f : kFar;
  for (int axis = 0; axis < 3; ++axis)
    nodes.alongLines(axis, [&](std::size_t first, std::size_t stride, std::size_t length) {
      replaceByEnvelope(&result[first], stride, length, nodes.spacingMm[axis]);
    });
  return result;
}

// Of the nodes that are deeper than `thick` those in connected parts that are somewhere as deep as `deep`.
Flags deepParts(const Nodes& nodes, const std::vector<float>& depth2, double thick2, double deep2) {
  Flags in(depth2.size()), deep(depth2.size());
  for (std::size_t i = 0; i < depth2.size(); ++i) in[i] = static_cast<double>(depth2[i]) > thick2;
  std::vector<std::size_t> waiting;
  for (std::size_t seed = 0; seed < depth2.size(); ++seed) {
    if (!in[seed] || static_cast<double>(depth2[seed]) < deep2) continue;
    in[seed] = 0;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const std::size_t node = waiting.back();
      waiting.pop_back();
      deep[node] = 1;
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t stride = nodes.stride(axis);
        const std::size_t at = node / stride % static_cast<std::size_t>(nodes.dims[axis]);
        const auto visit = [&](std::size_t next) {
          if (!in[next]) return;
          in[next] = 0;
          waiting.push_back(next);
        };
        if (at > 0) visit(node - stride);
        if (at + 1 < static_cast<std::size_t>(nodes.dims[axis])) visit(node + stride);
      }
    }
  }
  return deep;
}

// Fractions of the greatest depth, 0 outside the body.
std::vector<float> depths(const Nodes& nodes, const Flags& solid, const base::Progress& progress) {
  std::vector<float> depth2 = squaredDistances(nodes, solid, 0);
  progress.throwIfStopped();
  const double deepest2 = static_cast<double>(*std::max_element(depth2.begin(), depth2.end()));
  if (deepest2 >= static_cast<double>(kFar)) return std::vector<float>(solid.size(), 1.0f);
  const double thick = std::min(kThickMm, kThickPart * std::sqrt(deepest2));
  const std::vector<float> toPart2 =
      squaredDistances(nodes, deepParts(nodes, depth2, thick * thick, kDeepPart * kDeepPart * deepest2), 1);
  progress.throwIfStopped();
  for (std::size_t i = 0; i < depth2.size(); ++i)
    depth2[i] = static_cast<double>(toPart2[i]) <= thick * thick && deepest2 > 0.0
                    ? static_cast<float>(std::sqrt(static_cast<double>(depth2[i]) / deepest2))
                    : 0.0f;
  return depth2;
}

}  // namespace

Body::Body(const Grid& grid, double isovalue, base::Progress& progress) : isovalue_(isovalue) {
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  const glm::dvec3 extent = spacing * glm::dvec3(grid.dims());
  const double apart = std::max({extent.x, extent.y, extent.z}) / kNodesAlong;
  step_ = glm::max(glm::ivec3(glm::round(apart / spacing)), 1);
  dims_ = (grid.dims() + step_ - 1) / step_;
  const Nodes nodes{dims_, glm::dvec3(step_) * spacing};
  Flags above(nodes.count());
  const InsideLevel level = InsideLevel::of(grid, isovalue, scene::Inside::above);
  const Extent3 all{dims_};
  parallelEach(all.rows(), [&](std::size_t row) {
    for (glm::ivec3 at = all.firstOfRow(row); at.x < dims_.x; ++at.x) {
      const glm::ivec3 voxel = glm::min(at * step_ + step_ / 2, grid.dims() - 1);
      above[all.index(at)] = level.holds(static_cast<float>(grid.stored(voxel)));
    }
  });
  progress.throwIfStopped();
  depth_ = depths(nodes, solidOf(nodes, std::move(above)), progress);
}

std::vector<std::uint64_t> voxelsInBody(const Pieces& pieces, const Body& body, double depth) {
  std::vector<std::uint64_t> result(pieces.list().size());
  const PieceBlocks& blocks = pieces.blocks();
  const Extent3 extent{blocks.dims()};
  parallelEach(extent.rows(), [&](std::size_t row) {
    RunningSums counts(result);
    for (glm::ivec3 at = extent.firstOfRow(row); at.x < extent.dims.x; ++at.x) {
      const PieceBlocks::View block = blocks.view(at);
      if (!block.bits) continue;
      for (int z = 0; z < kPieceBlock; ++z)
        for (std::uint64_t bits = (*block.bits)[static_cast<std::size_t>(z)]; bits != 0; bits &= bits - 1) {
          const int bit = std::countr_zero(bits);
          const glm::ivec3 in(bit % 8, bit / 8, z), voxel = kPieceBlock * at + in;
          if (!Extent3{blocks.voxelDims()}.contains(voxel)) continue;
          const float here = body.depth(voxel);
          if (here > 0.0f && static_cast<double>(here) >= depth)
            counts.add(pieces.ofLabel(block.labelOf(in)), 1);
        }
    }
  });
  return result;
}

}  // namespace isolux::volume
