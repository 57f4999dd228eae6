#include "volume/prepared/prepared_volume.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include <tbb/combinable.h>

#include "base/clock.h"
#include "base/error.h"
#include "base/number_text.h"
#include "volume/bricks/brick_source.h"
#include "volume/labels/label_table.h"
#include "volume/large/coarse_level.h"
#include "volume/large/index_file.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/prepared/first_view.h"
#include "volume/prepared/read_source.h"
#include "volume/prepared/surface_outline.h"
#include "volume/read/input/chunked_header.h"
#include "volume/read/input/payload.h"
#include "volume/read/label_files.h"
#include "volume/statistics/label_map.h"
#include "volume/statistics/typical_step.h"

namespace isolux::volume {

namespace {

using Clock = std::chrono::steady_clock;

// The smallest box with all blocks for which isWanted(index) holds.
template <class IsWanted>
Bounds<glm::dvec3> boxOfBlocks(const MinMaxBlocks& blocks, const IsWanted& isWanted,
                               base::Progress& progress) {
  const Extent3 extent{blocks.dims()};
  tbb::combinable<Bounds<glm::dvec3>> partial;
  parallelSteps(extent.rows(), progress, {}, [&](std::size_t row) {
    for (glm::ivec3 at = extent.firstOfRow(row); at.x < extent.dims.x; ++at.x)
      if (isWanted(blocks.index(at))) partial.local().add(glm::dvec3(at));
  });
  Bounds<glm::dvec3> all;
  partial.combine_each([&](const Bounds<glm::dvec3>& box) { all.add(box); });
  return all;
}

double mostFrequent(const Histogram& histogram) {
  const auto most = std::ranges::max_element(histogram.counts);
  return histogram.binCentre(static_cast<std::size_t>(std::distance(histogram.counts.begin(), most)));
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
    const double background = mostFrequent(histogram);
    const auto upper = grid.storedIsovalue(facts.suggestedIsovalue);
    const auto lower = grid.storedIsovalue(0.5 * (background + facts.suggestedIsovalue));
    const auto contrast =
        static_cast<float>(0.1 * (grid.maximum() - grid.minimum()) / std::abs(grid.slope()));
    const Bounds<glm::dvec3> box = boxOfBlocks(
        blocks,
        [&](std::size_t i) {
          return blocks.active(i, upper) || blocks.active(i, lower) ||
                 blocks.maximum(i) - blocks.minimum(i) > contrast;
        },
        progress);
    if (box.low.x <= box.high.x) {
      low = glm::ivec3(box.low) * blocks.blockCells();
      high = glm::min((glm::ivec3(box.high) + 1) * blocks.blockCells(), high);
    }
  }
  Bounds<glm::dvec3> bounds;
  for (const glm::dvec3& corner : grid.geometry().corners(glm::dvec3(low), glm::dvec3(high)))
    bounds.add(corner);
  facts.boundsMinMm = bounds.low;
  facts.boundsMaxMm = bounds.high;
  const glm::dvec3 extent = facts.boundsMaxMm - facts.boundsMinMm;
  const double least = grid.geometry().leastSpacingMm();
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] >= least * 1e-6) continue;
    facts.boundsMinMm[axis] -= 0.5 * least;
    facts.boundsMaxMm[axis] += 0.5 * least;
  }
}

void setFirstView(PreparedVolume& prepared, base::Progress& progress) {
  const scene::Scene first = scene::resolve({}, prepared.facts);
  SurfaceOutline outline = surfaceOutline(prepared, first, true, progress);
  const auto [toEye, up] = firstView(outline.samples, prepared.facts.axes);
  prepared.facts.toEye = toEye;
  prepared.facts.up = up;
  prepared.facts.outlineMm = std::move(outline.pointsMm);
}

std::vector<double> valuesOfRow(const Grid& grid, int y, int z) {
  std::vector<double> values;
  for (int x = 0; x < grid.dims().x; ++x) values.push_back(grid.value(x, y, z));
  return values;
}

// A unit that cannot be right is worse than none. Who says what the values are has the last word.
void noteUnit(Volume& volume, const Histogram& histogram) {
  if (volume.kind != scene::DataKind::automatic) {
    if (volume.kind == scene::DataKind::ct_hu)
      volume.unit = "HU";
    else if (volume.unit == "HU")
      volume.unit.clear();
    return;
  }
  if (volume.unit != "HU" || !looksOffsetBy1024(histogram, volume.grid->minimum())) return;
  volume.unit.clear();
  volume.warnings.emplace_back("values look offset by 1024: not Hounsfield units as stored");
}

// Whether the file says that it has labels. Its voxels may contradict it: then nothing states them any more.
bool hasStatedLabels(Volume& volume, base::Progress& progress) {
  if (!statesLabels(volume.labelTable.get())) return false;
  if (!volume.grid->isWhole() || valueCounts(*volume.grid, kMostStatedLabels, progress)) return true;
  volume.warnings.push_back("labels are stated (" + volume.labelTable->reason +
                            "), but values are no whole numbers; taken for quantities");
  volume.labelTable.reset();
  return false;
}

// What pictures of a label map show.
enum class LabelsDrawn { asMask, asValues, notSaid };

// Labels are names: between them lies no isovalue, and they have no noise.
void noteLabels(Volume& volume, LabelsDrawn drawn, base::Progress& progress) {
  const bool asked = volume.kind == scene::DataKind::labels;
  if (!asked && volume.kind != scene::DataKind::automatic) return volume.labelTable.reset();
  const bool stated = !asked && hasStatedLabels(volume, progress);
  if (!asked && !stated && (volume.isovalue || volume.unit == "HU")) return;  // the source knows better
  const bool whole = volume.grid->isWhole();                                  // else nothing is counted
  std::optional<LabelMap> map;
  if (whole) map = labelMapOf(*volume.grid, asked || stated, progress);
  if (!map && !stated && (whole || !asked)) return;
  if (!map) map = LabelMap{};
  volume.labels = map->labels;
  volume.noise = 0.0;
  volume.isovalue = map->background + (map->background < volume.grid->maximum() ? 0.5 : -0.5);
  const std::string what = asked    ? "is taken for a label map"
                           : stated ? "is a label map (" + volume.labelTable->reason + ")"
                                    : "looks like a label map";
  std::string note =
      what + (whole ? " of " + std::to_string(map->labels) + (map->labels == 1 ? " label" : " labels") : "") +
      ": values are names of regions, not quantities";
  if (drawn == LabelsDrawn::asMask) note += "; drawn is the smooth surface around those of source.labels";
  if (drawn == LabelsDrawn::asValues)
    note += "; the isosurface at " + base::shortText(*volume.isovalue) + " encloses all of them" +
            (map->isOutermost ? "" : " that lie above the background");
  volume.warnings.push_back(std::move(note));
}

// "0.3 % of the voxels are drawn as in the file, too thin to smooth", or "".
std::string thinText(const ShownLabels& labels) {
  std::size_t voxels = 0;
  for (const LabelExtent& label : labels.blocks->list())
    if (std::ranges::binary_search(labels.mask.labels, label.label)) voxels += label.voxels;
  const double share = 100.0 * static_cast<double>(labels.mask.thinVoxels()) / static_cast<double>(voxels);
  if (!(share > 0.0)) return {};
  return base::shortText(share, 2) +
         " % of the shown labels' voxels are drawn as in the file, too thin to smooth";
}

// Puts the mask field of labels in the place of the labels.
void putMask(Volume& volume, const MaskField& mask) {
  volume.grid = mask.grid;
  volume.isovalue = 0.0;
  volume.noise = 0.0;
  volume.unit.clear();
}

// The same of the labels that are shown.
void showMask(Volume& volume, const ShownLabels& labels) {
  putMask(volume, labels.mask);
  if (const std::string thin = thinText(labels); !thin.empty()) volume.warnings.push_back(thin);
}

// With what is made when it is first asked for.
std::shared_ptr<PreparedVolume> withBlocks(Volume volume, std::shared_ptr<const MinMaxBlocks> blocks) {
  auto prepared = std::make_shared<PreparedVolume>();
  prepared->volume = std::move(volume);
  prepared->blocks = std::move(blocks);
  prepared->cubicFields = std::make_shared<CubicFields>(prepared->volume.grid);
  prepared->derivativeChoices = std::make_shared<DerivativeChoices>(
      prepared->volume.grid, prepared->blocks, prepared->volume.noise, prepared->volume.isMesh);
  prepared->stillHits = std::make_shared<StillHits>(prepared->volume.grid, prepared->blocks);
  prepared->pieces = std::make_shared<PieceSets>(prepared->volume.grid, prepared->blocks);
  prepared->secondVolumes = std::make_shared<SecondVolumes>(prepared->volume.grid);
  return prepared;
}

// What is noise of the background is no object: an isovalue lies so many of its deviations away, as far as
// the border within the object.
double awayFromNoise(const PreparedVolume& prepared, double isovalue, double contrast,
                     base::Progress& progress) {
  constexpr double deviations = 3.5;
  const double background = mostFrequent(prepared.histogram);
  const double away = deviations * prepared.derivativeChoices->noise(progress).at(isovalue);
  if (isovalue > background) return std::max(isovalue, std::min(background + away, contrast));
  return std::min(isovalue, std::max(background - away, contrast));
}

// As presets of MR have it: {"between": -0.4}.
double skinOfMr(const scene::VolumeFacts& facts) {
  return std::lerp(facts.contrastIsovalue, facts.minimum, 0.4);
}

void setKind(PreparedVolume& prepared, base::Progress& progress) {
  const scene::VolumeFacts& facts = prepared.facts;
  const Volume& volume = prepared.volume;
  prepared.kind = dataKindOf(volume, prepared.histogram, prepared.derivativeChoices->noise(progress));
  const bool maybeBrain = prepared.kind.kind == scene::DataKind::mr && volume.grid->isWhole();
  prepared.whiteMatter = maybeBrain ? std::make_shared<KeptWhiteMatter>(volume.grid, skinOfMr(facts))
                                    : std::make_shared<KeptWhiteMatter>(std::nullopt);
}

void setFacts(const std::shared_ptr<PreparedVolume>& prepared, Histogram histogram, double typicalStep,
              base::Progress& progress) {
  prepared->histogram = std::move(histogram);
  noteUnit(prepared->volume, prepared->histogram);
  scene::VolumeFacts& facts = prepared->facts;
  const std::string& unit = prepared->volume.unit;
  if (const std::optional<double>& known = prepared->volume.isovalue) {
    facts.suggestedIsovalue = facts.contrastIsovalue = *known;
  } else {
    facts.contrastIsovalue = contrastIsovalue(prepared->grid(), prepared->histogram, unit);
    facts.suggestedIsovalue =
        awayFromNoise(*prepared, suggestIsovalue(prepared->grid(), prepared->histogram, unit),
                      facts.contrastIsovalue, progress);
  }
  facts.suggestedIsovalues =
      prepared->volume.labels > 0 || prepared->volume.kind == scene::DataKind::labels ||
              statesLabels(prepared->volume.labelTable.get())
          ? std::vector<double>{facts.suggestedIsovalue}
          : suggestIsovalues(prepared->grid(), prepared->histogram, unit, facts.suggestedIsovalue);
  facts.axes = prepared->volume.axes;
  facts.spacingMm = prepared->grid().geometry().spacingMm();
  facts.minimum = prepared->grid().minimum();
  facts.maximum = prepared->grid().maximum();
  facts.typicalStep = typicalStep;
  setKind(*prepared, progress);
  setBounds(*prepared, progress);
  setFirstView(*prepared, progress);
}

// The index of the file, made where there is none; what hinders keeping it is a warning.
VolumeIndex indexOf(const ChunkedVolume& file, const scene::Source& source,
                    std::vector<std::string>& warnings, base::Progress& progress) {
  const IndexFile kept(source.path, readOptions(source));
  std::optional<VolumeIndex> index = kept.find(file);
  if (index) return std::move(*index);
  try {
    kept.make(file, {}, index, progress);
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input || !index || !index->isComplete()) throw;
    warnings.push_back(std::string("the index could not be kept: ") + error.what());
  }
  return std::move(*index);
}

// What is left of the budget beside the blocks, their flags and masks, which are in memory all the time; at
// least a quarter.
std::size_t brickBudget(int ramBudgetMb, const MinMaxBlocks& blocks) {
  const std::size_t budget = static_cast<std::size_t>(ramBudgetMb) << 20,
                    index =
                        blocks.count() * (2 * sizeof(float) + sizeof(std::uint8_t) + sizeof(std::uint64_t));
  return std::max(budget / 4, budget - std::min(budget, index));
}

std::shared_ptr<PreparedVolume> prepareFile(const std::shared_ptr<const ChunkedVolume>& file,
                                            const scene::Source& source, int ramBudgetMb,
                                            base::Progress& progress) {
  const Clock::time_point start = Clock::now();
  const ChunkedFacts& facts = file->facts();
  const GridGeometry& geometry = facts.levels.front().geometry;
  Volume volume = volumeOf(chunkedHeader(facts, geometry, facts.storedType), readOptions(source));
  takeNames(volume, facts);
  volume.kind = source.kind;
  noteStep(volume, source.timeStep);
  const VolumeIndex index = indexOf(*file, source, volume.warnings, progress);
  const double readSeconds = base::secondsSince(start);
  auto bricks =
      std::make_shared<BrickSource>(file, VolumePart{static_cast<int>(source.timeStep), source.component},
                                    brickBudget(ramBudgetMb, *index.blocks()));
  const auto gridOf = [&](double slope, double intercept) {
    return std::make_shared<Grid>(geometry, index.voxelFacts(slope, intercept), slope, intercept, bricks);
  };
  std::shared_ptr<Grid> grid = gridOf(facts.slope, facts.intercept);
  bool scaled = facts.slope != 1.0 || facts.intercept != 0.0;
  if (scaled && !scalingIsUsable(*grid)) {
    volume.warnings.emplace_back(kScalingLeftOut);
    grid = gridOf(1.0, 0.0);
    scaled = false;
  }
  noteMissing(volume, *grid);
  if (!index.damaged().empty()) volume.warnings.push_back(damageText(index.damaged()));
  volume.grid = std::move(grid);
  addLabelFiles(volume, source.path);
  if (!source.labelNames.empty()) nameLabels(volume, source.labelNames);
  noteLabels(volume, LabelsDrawn::asValues, progress);
  const std::shared_ptr<PreparedVolume> prepared = withBlocks(std::move(volume), index.blocks());
  setFacts(prepared, index.histogram(prepared->grid()), index.typicalStep(scaled), progress);
  prepared->readSeconds = readSeconds;
  prepared->prepareSeconds = base::secondsSince(start) - readSeconds;
  return prepared;
}

// `histogram`: of the grid, where it is known; `before`: of a grid that differs at most in blocks whose byte
// of `changed` is not 0, or null.
std::shared_ptr<PreparedVolume> prepareGrid(Volume volume, std::optional<Histogram> histogram,
                                            const PreparedVolume* before,
                                            std::span<const std::uint8_t> changed, base::Progress& progress) {
  const Clock::time_point start = Clock::now();
  progress.report(0.0, "building blocks");
  auto blocks = before ? std::make_shared<MinMaxBlocks>(*before->blocks, *volume.grid, changed, progress)
                       : std::make_shared<MinMaxBlocks>(*volume.grid, kBlockCells, progress);
  const std::shared_ptr<PreparedVolume> prepared = withBlocks(std::move(volume), std::move(blocks));
  progress.report(0.3, "building blocks");
  prepared->boxes = before ? std::make_shared<BoxBounds>(*before->boxes, prepared->grid(), *prepared->blocks,
                                                         changed, progress)
                           : std::make_shared<BoxBounds>(prepared->grid(), *prepared->blocks, progress);
  progress.report(0.7, "counting values");
  const Grid& grid = prepared->grid();
  if (!histogram) histogram = makeHistogram(grid, 512, progress);
  const double step = typicalStep(
      grid.dims(), [&](int y, int z) { return valuesOfRow(grid, y, z); }, progress);
  setFacts(prepared, std::move(*histogram), step, progress);
  prepared->prepareSeconds = base::secondsSince(start);
  progress.report(1.0, "ready");
  return prepared;
}

std::shared_ptr<PreparedVolume> prepareGrid(Volume volume, base::Progress& progress) {
  return prepareGrid(std::move(volume), std::nullopt, nullptr, {}, progress);
}

// How many voxels a mask has outside and inside; the values between are those of its smoothing.
Histogram histogramOf(const ShownLabels& labels) {
  std::uint64_t inside = 0;
  for (const LabelExtent& label : labels.blocks->list())
    if (std::ranges::binary_search(labels.mask.labels, label.label)) inside += label.voxels;
  return {-1.0, 1.0, {labels.grid().geometry().voxelCount() - inside, inside}, {}};
}

// Of a label map in whole: the surface of the labels that the source names. `before`: of the same map, or
// null.
std::shared_ptr<PreparedVolume> prepareLabels(Volume asRead, std::shared_ptr<const ShownLabels> labels,
                                              const PreparedVolume* before, base::Progress& progress) {
  Volume masked = asRead;
  showMask(masked, *labels);
  const bool isKnown = before && !labels->mask.changed.empty();
  std::vector<std::uint8_t> changed;
  if (isKnown) changed = cellBlocksIn(labels->mask.changed, labels->grid().dims());
  std::shared_ptr<PreparedVolume> prepared =
      prepareGrid(std::move(masked), histogramOf(*labels), isKnown ? before : nullptr, changed, progress);
  prepared->facts.labelAlbedo = meanColor(*labels, labels->mask.labels);
  prepared->labelSurfaces =
      before ? before->labelSurfaces : std::make_shared<LabelSurfaces>(asRead, labels->blocks, labels->table);
  prepared->labels = std::move(labels);
  prepared->asRead = std::move(asRead);
  return prepared;
}

std::shared_ptr<PreparedVolume> prepare(Volume volume, const scene::Source& source,
                                        base::Progress& progress) {
  const bool asValues = source.labels == scene::kLabelsAsValues;
  if (!source.labelNames.empty()) nameLabels(volume, source.labelNames);
  noteLabels(volume, asValues ? LabelsDrawn::notSaid : LabelsDrawn::asMask, progress);
  if (volume.labels == 0 || asValues) return prepareGrid(std::move(volume), progress);
  progress.report(0.0, "finding labels");
  auto blocks = std::make_shared<LabelBlocks>(volume.grid, volume.name, progress);
  std::shared_ptr<const ShownLabels> labels =
      showLabels(std::move(blocks), volume.labelTable, source.labels, source.smoothing, nullptr, progress);
  return prepareLabels(std::move(volume), std::move(labels), nullptr, progress);
}

// Whether the voxels stay in their file.
bool stays(const VolumeFile& file, const scene::Source& source, scene::VoxelPlace place) {
  if (place == scene::VoxelPlace::memory) return false;
  if (place == scene::VoxelPlace::automatic)
    return source.level == 0 && file.parts &&
           levelBytes(file.parts->facts(), 0) > base::machineMemory().left();
  if (source.level > 0)
    base::throwUsage(source.path, "memory.voxels=file",
                     "is of level 0 alone, and source.level is " + std::to_string(source.level));
  if (!file.parts)
    base::throwInput(source.path, "memory.voxels=file", "cannot be read in parts: " + file.whyWhole);
  return true;
}

}  // namespace

std::shared_ptr<const PreparedVolume> prepareMask(Volume volume, std::shared_ptr<const ShownLabels> labels,
                                                  base::Progress& progress) {
  putMask(volume, labels->mask);
  auto blocks = std::make_shared<MinMaxBlocks>(*volume.grid, kBlockCells, progress);
  const std::shared_ptr<PreparedVolume> prepared = withBlocks(std::move(volume), std::move(blocks));
  prepared->boxes = std::make_shared<BoxBounds>(prepared->grid(), *prepared->blocks, progress);
  prepared->labels = std::move(labels);
  prepared->facts.axes = prepared->volume.axes;
  return prepared;
}

std::shared_ptr<const PreparedVolume> prepareVolume(Volume volume, base::Progress& progress) {
  return prepare(std::move(volume), withLabelsAsValues({}), progress);
}

std::shared_ptr<const PreparedVolume> showOtherLabels(const PreparedVolume& shown,
                                                      const scene::Source& source, base::Progress& progress) {
  const ShownLabels& before = *shown.labels;
  return prepareLabels(
      *shown.asRead,
      showLabels(before.blocks, before.table, source.labels, source.smoothing, &before, progress), &shown,
      progress);
}

std::shared_ptr<const PreparedVolume> loadVolume(const scene::Source& source, const scene::HostSettings& host,
                                                 base::Progress& progress) {
  const VolumeFile file = openSource(source, progress);
  return stays(file, source, host.voxels) ? prepareFile(file.parts, source, host.ramBudgetMb, progress)
                                          : loadVolume(source, file, progress);
}

std::shared_ptr<const PreparedVolume> loadVolume(const scene::Source& source, base::Progress& progress) {
  return loadVolume(source, openSource(source, progress), progress);
}

std::shared_ptr<const PreparedVolume> loadVolume(const scene::Source& source, const VolumeFile& first,
                                                 base::Progress& progress) {
  const Clock::time_point start = Clock::now();
  progress.report(0.0, "reading");
  CsgResult read = readSource(source, first, progress);
  if (source.csg != scene::Csg::none) read.volume.noise.reset();  // known of the first alone
  const double readSeconds = base::secondsSince(start);
  read.volume.kind = source.kind;
  const std::shared_ptr<PreparedVolume> prepared = prepare(std::move(read.volume), source, progress);
  prepared->readSeconds = readSeconds;
  prepared->facts.csgIsovalue = read.secondIsovalue;
  return prepared;
}

}  // namespace isolux::volume
