#include "volume/prepared_volume.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <tbb/combinable.h>

#include "volume/mesh/csg.h"
#include "volume/parallel_steps.h"
#include "volume/statistics/plausibility.h"

namespace isolux::volume {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct BlockBox {
  glm::ivec3 first, last;  // of blocks; last.x < 0 when there is none
};

// The smallest box with all blocks for which isWanted(index) holds.
template <class IsWanted>
BlockBox boxOfBlocks(const MinMaxBlocks& blocks, const IsWanted& isWanted, base::Progress& progress) {
  const glm::ivec3 dims = blocks.dims();
  tbb::combinable<BlockBox> partial([&] { return BlockBox{dims, glm::ivec3(-1)}; });
  parallelSteps(static_cast<std::size_t>(dims.z), progress, {}, [&](std::size_t layer) {
    BlockBox& box = partial.local();
    const auto z = static_cast<int>(layer);
    std::size_t i = blocks.index({0, 0, z});
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++i)
        if (isWanted(i)) {
          box.first = glm::min(box.first, glm::ivec3(x, y, z));
          box.last = glm::max(box.last, glm::ivec3(x, y, z));
        }
  });
  BlockBox all{dims, glm::ivec3(-1)};
  partial.combine_each([&](const BlockBox& box) {
    all.first = glm::min(all.first, box.first);
    all.last = glm::max(all.last, box.last);
  });
  return all;
}

// Where the user will look: the world box of the blocks with structure in them, i.e. a surface of the
// suggested isovalue, or of the one half-way from the most frequent value (the background) to it, or a tenth
// of the whole range of values. So dragging the isovalue from bone down to skin stays in the picture, while
// noise in air does not count. The whole domain when there is no such block. An axis along which the box has
// no extent (a single slice) gets half a voxel on both sides, so that a camera can be placed before any
// volume.
void setBounds(PreparedVolume& prepared, base::Progress& progress) {
  const Grid& grid = prepared.grid();
  const MinMaxBlocks& blocks = *prepared.blocks;
  const Histogram& histogram = prepared.histogram;
  scene::VolumeFacts& facts = prepared.facts;

  glm::ivec3 low(0), high = grid.dims() - 1;
  if (!histogram.counts.empty()) {
    const auto most = std::max_element(histogram.counts.begin(), histogram.counts.end());
    const double background =
        histogram.binCentre(static_cast<std::size_t>(std::distance(histogram.counts.begin(), most)));
    const auto upper = static_cast<float>(grid.storedOfValue(facts.suggestedIsovalue));
    const auto lower = static_cast<float>(grid.storedOfValue(0.5 * (background + facts.suggestedIsovalue)));
    const auto contrast =
        static_cast<float>(0.1 * (grid.maximum() - grid.minimum()) / std::abs(grid.slope()));
    const BlockBox box = boxOfBlocks(
        blocks,
        [&](std::size_t i) {
          return blocks.active(i, upper) || blocks.active(i, lower) ||
                 blocks.maximum(i) - blocks.minimum(i) > contrast;
        },
        progress);
    const glm::ivec3 first = box.first, last = box.last;
    if (last.x >= 0) {
      low = first * blocks.blockCells();
      high = glm::min((last + 1) * blocks.blockCells(), high);
    }
  }
  facts.boundsMinMm = glm::dvec3(std::numeric_limits<double>::infinity());
  facts.boundsMaxMm = -facts.boundsMinMm;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 voxel((corner & 1) ? high.x : low.x, (corner & 2) ? high.y : low.y,
                           (corner & 4) ? high.z : low.z, 1.0);
    const glm::dvec3 world(grid.geometry().worldFromVoxel * voxel);
    facts.boundsMinMm = glm::min(facts.boundsMinMm, world);
    facts.boundsMaxMm = glm::max(facts.boundsMaxMm, world);
  }
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  const glm::dvec3 extent = facts.boundsMaxMm - facts.boundsMinMm;
  const double least = std::min({spacing.x, spacing.y, spacing.z});
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] >= least * 1e-6) continue;
    facts.boundsMinMm[axis] -= 0.5 * least;
    facts.boundsMaxMm[axis] += 0.5 * least;
  }
}

// What neighbouring voxels differ by where they differ, along any axis: the 90 % quantile over an even
// subsample of the rows.
double typicalStep(const Grid& grid, const base::Progress& progress) {
  const glm::ivec3 n = grid.dims();
  constexpr std::ptrdiff_t enough = 1 << 16;
  const std::ptrdiff_t rows = std::ptrdiff_t{n.y} * n.z,
                       stride = std::max<std::ptrdiff_t>(1, rows * n.x / enough);
  std::vector<double> steps;
  for (std::ptrdiff_t row = 0; row < rows; row += stride) {
    progress.throwIfStopped();
    const int y = static_cast<int>(row % n.y), z = static_cast<int>(row / n.y);
    for (int x = 0; x < n.x; ++x) {
      for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 next(x, y, z);
        if (++next[axis] == n[axis]) continue;
        const double step = std::abs(grid.value(next.x, next.y, next.z) - grid.value(x, y, z));
        if (step > 0.0) steps.push_back(step);  // false for missing voxels
      }
    }
  }
  if (steps.empty()) return 0.0;
  const auto at = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() * 9 / 10);
  std::nth_element(steps.begin(), at, steps.end());
  return *at;
}

// The volume of a source, and the second one's isovalue where there is one.
CsgResult readSource(const scene::Source& source, base::Progress& progress) {
  ReadOptions options = readOptions(source);
  const bool combines = source.csg != scene::Csg::none && !source.csgPath.empty();
  ReadOptions second;  // series, component and time step are the first one's
  second.meshVoxels = source.meshVoxels;
  if (combines && source.csg == scene::Csg::unite)
    options.alsoHold = meshBounds(source.csgPath, second, progress);
  CsgResult result;
  result.volume = readVolume(source.path, options, progress);
  if (source.csg != scene::Csg::none && !combines)
    result.volume.warnings.emplace_back("source.csg_path is empty: there is no second volume to combine");
  if (!combines) return result;
  second.grid = result.volume.grid->geometry();
  return combined(result.volume, readVolume(source.csgPath, second, progress), source.csg, source.csgValue,
                  progress);
}

// A unit that cannot be right is worse than none.
void noteImplausible(Volume& volume, const Histogram& histogram) {
  if (volume.unit != "HU" || !looksOffsetBy1024(histogram, volume.grid->minimum())) return;
  volume.unit.clear();
  volume.warnings.emplace_back("values look offset by 1024: not Hounsfield units as stored");
}

std::shared_ptr<PreparedVolume> prepare(Volume volume, base::Progress& progress) {
  const Clock::time_point start = Clock::now();
  auto prepared = std::make_shared<PreparedVolume>();
  prepared->volume = std::move(volume);
  progress.report(0.0, "building blocks");
  prepared->blocks = std::make_shared<MinMaxBlocks>(prepared->grid(), kBlockCells, progress);
  progress.report(0.3, "building blocks");
  prepared->boxes = std::make_shared<BoxBounds>(prepared->grid(), progress);
  prepared->cubicFields = std::make_shared<CubicFields>(prepared->volume.grid);
  prepared->derivativeChoices =
      std::make_shared<DerivativeChoices>(prepared->volume.grid, prepared->blocks, prepared->volume.noise);
  prepared->stillHits = std::make_shared<StillHits>(prepared->volume.grid, prepared->blocks);
  prepared->pieces = std::make_shared<PieceSets>(prepared->volume.grid, prepared->blocks);
  prepared->secondVolumes = std::make_shared<SecondVolumes>(prepared->volume.grid);
  progress.report(0.7, "counting values");
  prepared->histogram = makeHistogram(prepared->grid(), 512, progress);
  noteImplausible(prepared->volume, prepared->histogram);
  const std::optional<double>& known = prepared->volume.isovalue;
  prepared->facts.suggestedIsovalue =
      known ? *known : suggestIsovalue(prepared->grid(), prepared->histogram, prepared->volume.unit);
  prepared->facts.suggestedIsovalues = suggestIsovalues(
      prepared->grid(), prepared->histogram, prepared->volume.unit, prepared->facts.suggestedIsovalue);
  prepared->facts.axes = prepared->volume.axes;
  prepared->facts.spacingMm = prepared->grid().geometry().spacingMm();
  prepared->facts.minimum = prepared->grid().minimum();
  prepared->facts.maximum = prepared->grid().maximum();
  prepared->facts.typicalStep = typicalStep(prepared->grid(), progress);
  setBounds(*prepared, progress);
  prepared->prepareSeconds = secondsSince(start);
  progress.report(1.0, "ready");
  return prepared;
}

}  // namespace

std::shared_ptr<const PreparedVolume> prepareVolume(Volume volume, base::Progress& progress) {
  return prepare(std::move(volume), progress);
}

std::shared_ptr<const PreparedVolume> loadVolume(const scene::Source& source, base::Progress& progress) {
  const Clock::time_point start = Clock::now();
  progress.report(0.0, "reading");
  CsgResult read = readSource(source, progress);
  if (source.csg != scene::Csg::none) read.volume.noise.reset();  // known of the first alone
  const double readSeconds = secondsSince(start);
  const std::shared_ptr<PreparedVolume> prepared = prepare(std::move(read.volume), progress);
  prepared->readSeconds = readSeconds;
  prepared->facts.csgIsovalue = read.secondIsovalue;
  return prepared;
}

}  // namespace isolux::volume
