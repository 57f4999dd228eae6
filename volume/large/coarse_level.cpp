#include "volume/large/coarse_level.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/number_text.h"
#include "volume/bricks/level_voxels.h"
#include "volume/labels/label_table.h"
#include "volume/read/input/chunked_header.h"
#include "volume/read/input/payload.h"
#include "volume/read/label_files.h"

namespace isolux::volume {

namespace {

constexpr int kLeastVoxels = 8;  // that halving leaves of an axis

LevelOrigin originOf(const ChunkedFacts& facts, int level) {
  const int last = static_cast<int>(facts.levels.size()) - 1, own = std::min(level, last);
  LevelOrigin origin{static_cast<std::size_t>(own), glm::ivec3(1)};
  const glm::ivec3 dims = facts.levels[origin.fileLevel].geometry.dims;
  for (int halving = own; halving < level; ++halving)
    for (int axis = 0; axis < 3; ++axis)
      if (dims[axis] / (2 * origin.factor[axis]) >= kLeastVoxels) origin.factor[axis] *= 2;
  return origin;
}

// Behind it nothing would change.
int coarsestLevel(const ChunkedFacts& facts) {
  const glm::ivec3 dims = facts.levels.back().geometry.dims;
  int level = static_cast<int>(facts.levels.size()) - 1;
  for (int longest = std::max({dims.x, dims.y, dims.z}); longest / 2 >= kLeastVoxels; longest /= 2) ++level;
  return level;
}

// 0 <= level <= coarsestLevel().
GridGeometry levelGeometry(const ChunkedFacts& facts, int level) {
  const LevelOrigin origin = originOf(facts, level);
  GridGeometry geometry = facts.levels[origin.fileLevel].geometry;
  if (origin.factor == glm::ivec3(1)) return geometry;
  const glm::dvec3 factor(origin.factor);
  geometry.dims = (geometry.dims + origin.factor - 1) / origin.factor;
  geometry.worldFromVoxel = glm::scale(glm::translate(geometry.worldFromVoxel, 0.5 * (factor - 1.0)), factor);
  return geometry;
}

std::string timesText(glm::dvec3 n) {
  return base::shortText(n.x) + "x" + base::shortText(n.y) + "x" + base::shortText(n.z);
}

// What level is missing and what that hides, in a sentence.
std::string levelNote(const ChunkedFacts& facts, int level) {
  const GridGeometry& whole = facts.levels.front().geometry;
  const GridGeometry coarse = levelGeometry(facts, level);
  const glm::dvec3 factor = coarse.spacingMm() / whole.spacingMm(), thin = 2.0 * coarse.spacingMm();
  return "level " + std::to_string(level) + ": each voxel is the mean of " + timesText(factor) +
         " of the file's " + timesText(whole.dims) + "; structures thinner than " +
         base::shortText(std::max({thin.x, thin.y, thin.z}), 3) + " mm may be missing";
}

// Means of labels are no labels.
void checkLabelLevel(const scene::Source& source, const LevelOrigin& origin) {
  if (origin.factor != glm::ivec3(1))
    base::throwUsage(source.path, "source.level=" + std::to_string(source.level),
                     "its voxels are labels, which have no means; the coarsest level that the file has is " +
                         std::to_string(origin.fileLevel));
}

// Where any are missing, of a type that knows missing ones.
FileVoxels voxelsOf(LevelVoxels&& read, const scene::Source& source, const ReadOptions& options,
                    base::Progress& progress) {
  if (read.unknown.empty()) return fileVoxels(std::move(read.voxels));
  const std::size_t count = std::visit([](const auto& voxels) { return voxels.size(); }, read.voxels);
  checkBudget(count * sizeof(float), "voxels some of which are missing", "a higher source.level needs less",
              source.path, options);
  return withMissing(read, progress);
}

}  // namespace

std::size_t levelBytes(const ChunkedFacts& facts, int level) {
  const std::size_t voxels = levelGeometry(facts, level).voxelCount();
  const std::size_t own = bytesOf(facts.storedType);
  return voxels * (level == 0 ? std::max(own, facts.wholeVoxelBytes) : own) + voxels / 2;
}

int levelThatFits(const VolumeFile& file, int finest, double share) {
  if (!file.parts) return 0;
  const ChunkedFacts& facts = file.parts->facts();
  const std::size_t left = base::machineMemory().left();
  const int last = coarsestLevel(facts);
  int level = std::min(finest, last);
  const auto room = [&] {
    return level == 0 ? left : static_cast<std::size_t>(share * static_cast<double>(left));
  };
  while (level < last && levelBytes(facts, level) > room()) ++level;
  return level;
}

Volume readLevel(const VolumeFile& file, const scene::Source& source, base::Progress& progress) {
  if (!file.parts)
    base::throwUsage(source.path, "source.level=" + std::to_string(source.level),
                     "only files that are read in parts have coarser levels: " + file.whyWhole);
  const ChunkedFacts& facts = file.parts->facts();
  if (source.level > coarsestLevel(facts))
    base::throwUsage(source.path, "source.level",
                     "level " + std::to_string(source.level) + " does not exist; the coarsest is " +
                         std::to_string(coarsestLevel(facts)));
  const LevelOrigin origin = originOf(facts, source.level);
  if (source.kind == scene::DataKind::labels || statesLabels(facts.labels.get()) ||
      !labelsByName(source.path).empty())
    checkLabelLevel(source, origin);
  const ReadOptions options = readOptions(source);
  const GridGeometry geometry = levelGeometry(facts, source.level);
  ImageHeader header = chunkedHeader(facts, geometry, facts.storedType);
  checkBudget(header, source.path, options);
  const VolumePart part{static_cast<int>(source.timeStep), source.component};
  LevelVoxels read = readLevelVoxels(*file.parts, part, origin, geometry.dims, source.aroundDamage, progress);
  const std::string damage = read.damaged.empty() ? "" : damageText(read.damaged);
  if (source.level > 0) header.warnings.insert(header.warnings.begin(), levelNote(facts, source.level));
  if (!damage.empty())
    header.warnings.insert(header.warnings.begin(), damage + "; its voxels count as missing");
  Volume volume =
      finishVolume(header, voxelsOf(std::move(read), source, options, progress), options, progress);
  if (!damage.empty() && volume.grid->missingCount() == geometry.voxelCount())
    base::throwInput(source.path, "", damage);
  volume.damage = damage;
  volume.coarsestLevel = coarsestLevel(facts);
  takeNames(volume, facts);
  addLabelFiles(volume, source.path);
  return volume;
}

}  // namespace isolux::volume
