#include "volume/bricks/coarse_level.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/number_text.h"
#include "volume/bricks/chunked_header.h"
#include "volume/bricks/hdf5/hdf5.h"
#include "volume/bricks/open_chunked.h"
#include "volume/bricks/stored_type.h"
#include "volume/parallel_steps.h"
#include "volume/read/input/payload.h"

namespace isolux::volume {

namespace {

constexpr int kLeastVoxels = 8;                            // that halving leaves of an axis
constexpr std::size_t kPieceBytes = std::size_t{4} << 20;  // of rows that are read at a time

// The file's level that a level is made of, and how many of its voxels make one.
struct Origin {
  std::size_t fileLevel = 0;
  glm::ivec3 factor{1};
};

Origin originOf(const ChunkedFacts& facts, int level) {
  const int last = static_cast<int>(facts.levels.size()) - 1, own = std::min(level, last);
  Origin origin{static_cast<std::size_t>(own), glm::ivec3(1)};
  const glm::ivec3 dims = facts.levels[origin.fileLevel].geometry.dims;
  for (int halving = own; halving < level; ++halving)
    for (int axis = 0; axis < 3; ++axis)
      if (dims[axis] / (2 * origin.factor[axis]) >= kLeastVoxels) origin.factor[axis] *= 2;
  return origin;
}

std::size_t voxelsIn(glm::ivec3 size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
         static_cast<std::size_t>(size.z);
}

std::string timesText(glm::dvec3 n) {
  return base::shortText(n.x) + "x" + base::shortText(n.y) + "x" + base::shortText(n.z);
}

// Voxels of the file's level whose means are made together: whole means, and of chunks that are packed whole
// ones.
glm::ivec3 stepOf(const ChunkedLevel& level, glm::ivec3 factor, std::size_t voxelBytes) {
  const glm::ivec3 dims = level.geometry.dims, chunk = level.cheapParts
                                                           ? glm::ivec3(dims.x, 1, 1)
                                                           : glm::clamp(level.chunkDims, glm::ivec3(1), dims);
  glm::ivec3 step = (chunk + factor - 1) / factor * factor;
  for (const int axis : {1, 2})
    while (step[axis] < dims[axis] && voxelsIn(step) * voxelBytes < kPieceBytes) step[axis] *= 2;
  return step;
}

// Voxels of a step that are read at a time; where parts are not cheap, the chunk that `at` lies in.
glm::ivec3 pieceOf(const ChunkedLevel& level, glm::ivec3 at, glm::ivec3 left, std::size_t voxelBytes) {
  if (!level.cheapParts) {
    const glm::ivec3 chunk = glm::clamp(level.chunkDims, glm::ivec3(1), level.geometry.dims);
    return glm::min(left, (at / chunk + 1) * chunk - at);
  }
  const std::size_t row = static_cast<std::size_t>(left.x) * voxelBytes,
                    slice = row * static_cast<std::size_t>(left.y);
  const auto most = [](std::size_t bytes, int n) {
    return static_cast<int>(std::clamp<std::size_t>(kPieceBytes / bytes, 1, static_cast<std::size_t>(n)));
  };
  return {left.x, most(row, left.y), most(slice, left.z)};
}

// Sums over the voxels of a step, by the mean that each belongs to.
class Means {
 public:
  Means(glm::ivec3 low, glm::ivec3 size, glm::ivec3 factor, glm::ivec3 dims)
      : first_(low / factor),
        size_((low + size + factor - 1) / factor - first_),
        factor_(factor),
        dims_(dims) {
    sums_.resize(voxelsIn(size_), 0.0);
    weights_.resize(voxelsIn(size_), 0.0);
  }
  template <class T>
  void add(glm::ivec3 low, glm::ivec3 size, const std::vector<T>& voxels) {
    std::size_t i = 0;
    for (int z = low.z; z < low.z + size.z; ++z)
      for (int y = low.y; y < low.y + size.y; ++y) {
        const double weight = weightOf(y, 1) * weightOf(z, 2);
        const std::size_t row = indexOf({first_.x, y / factor_.y, z / factor_.z});
        for (int x = low.x; x < low.x + size.x; ++x, ++i) {
          if constexpr (std::is_floating_point_v<T>)
            if (!std::isfinite(voxels[i])) continue;
          const double w = weight * weightOf(x, 0);
          const std::size_t mean = row + static_cast<std::size_t>(x / factor_.x - first_.x);
          sums_[mean] += w * static_cast<double>(voxels[i]);
          weights_[mean] += w;
        }
      }
  }
  // Into a level of these dims.
  template <class T>
  void write(glm::ivec3 levelDims, std::vector<T>& level) const {
    std::size_t i = 0;
    for (int z = first_.z; z < first_.z + size_.z; ++z)
      for (int y = first_.y; y < first_.y + size_.y; ++y)
        for (int x = first_.x; x < first_.x + size_.x; ++x, ++i) {
          const double mean = sums_[i] / weights_[i];  // NaN where nothing is known
          T& to = level[(static_cast<std::size_t>(z) * static_cast<std::size_t>(levelDims.y) +
                         static_cast<std::size_t>(y)) *
                            static_cast<std::size_t>(levelDims.x) +
                        static_cast<std::size_t>(x)];
          if constexpr (std::is_floating_point_v<T>)
            to = static_cast<T>(mean);
          else
            to = static_cast<T>(std::lround(mean));
        }
  }

 private:
  // How often a voxel counts: the last of an axis stands for those that its mean lacks.
  double weightOf(int at, int axis) const {
    return at + 1 == dims_[axis] ? static_cast<double>(factor_[axis] - at % factor_[axis]) : 1.0;
  }
  std::size_t indexOf(glm::ivec3 mean) const {
    const glm::ivec3 at = mean - first_;
    return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(size_.y) +
            static_cast<std::size_t>(at.y)) *
               static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(at.x);
  }

  glm::ivec3 first_, size_, factor_, dims_;
  std::vector<double> sums_, weights_;
};

template <class T>
std::vector<T> readMeans(const ChunkedVolume& file, VolumePart part, const Origin& origin, glm::ivec3 dims,
                         base::Progress& progress) {
  const ChunkedLevel& level = file.facts().levels[origin.fileLevel];
  const glm::ivec3 from = level.geometry.dims, step = stepOf(level, origin.factor, sizeof(T));
  const glm::ivec3 steps = (from + step - 1) / step;
  std::vector<T> voxels;
  resizeStoppably(voxels, voxelsIn(dims), progress);
  const auto nx = static_cast<std::size_t>(steps.x), ny = static_cast<std::size_t>(steps.y);
  parallelSteps(voxelsIn(steps), progress, {0.0, 1.0, "reading"}, [&](std::size_t i) {
    const glm::ivec3 low = step * glm::ivec3(static_cast<int>(i % nx), static_cast<int>(i / nx % ny),
                                             static_cast<int>(i / nx / ny));
    const glm::ivec3 behind = glm::min(low + step, from);
    Means means(low, behind - low, origin.factor, from);
    std::vector<T> piece;
    glm::ivec3 size;
    for (glm::ivec3 at = low; at.z < behind.z; at.z += size.z)
      for (at.y = low.y; at.y < behind.y; at.y += size.y)
        for (at.x = low.x; at.x < behind.x; at.x += size.x) {
          if (progress.stopRequested()) return;
          size = pieceOf(level, at, behind - at, sizeof(T));
          piece.resize(voxelsIn(size));
          file.read(part, origin.fileLevel, at, size, std::as_writable_bytes(std::span(piece)));
          means.add(at, size, piece);
        }
    means.write(dims, voxels);
  });
  return voxels;
}

std::shared_ptr<const ChunkedVolume> opened(const scene::Source& source, base::Progress& progress) {
  std::string reason;
  std::shared_ptr<const ChunkedVolume> file = openChunked(source, reason, progress);
  if (file) return file;
  throw base::Error(base::ErrorKind::usage, source.path, "source.level=" + std::to_string(source.level),
                    "only files that are read in parts have coarser levels: " + reason);
}

}  // namespace

int coarsestLevel(const ChunkedFacts& facts) {
  const glm::ivec3 dims = facts.levels.back().geometry.dims;
  int level = static_cast<int>(facts.levels.size()) - 1;
  for (int longest = std::max({dims.x, dims.y, dims.z}); longest / 2 >= kLeastVoxels; longest /= 2) ++level;
  return level;
}

GridGeometry levelGeometry(const ChunkedFacts& facts, int level) {
  const Origin origin = originOf(facts, level);
  GridGeometry geometry = facts.levels[origin.fileLevel].geometry;
  if (origin.factor == glm::ivec3(1)) return geometry;
  const glm::dvec3 factor(origin.factor);
  geometry.dims = (geometry.dims + origin.factor - 1) / origin.factor;
  geometry.worldFromVoxel = glm::scale(glm::translate(geometry.worldFromVoxel, 0.5 * (factor - 1.0)), factor);
  return geometry;
}

std::size_t levelBytes(const ChunkedFacts& facts, int level) {
  const std::size_t voxels = levelGeometry(facts, level).voxelCount();
  const std::size_t own = bytesOf(facts.storedType);
  return voxels * (level == 0 ? std::max(own, facts.wholeVoxelBytes) : own) + voxels / 2;
}

std::string levelNote(const ChunkedFacts& facts, int level) {
  const GridGeometry& whole = facts.levels.front().geometry;
  const GridGeometry coarse = levelGeometry(facts, level);
  const glm::dvec3 factor = coarse.spacingMm() / whole.spacingMm(), thin = 2.0 * coarse.spacingMm();
  return "level " + std::to_string(level) + ": each voxel is the mean of " + timesText(factor) +
         " of the file's " + timesText(whole.dims) + "; what is thinner than " +
         base::shortText(std::max({thin.x, thin.y, thin.z}), 3) + " mm may be missing";
}

int levelThatFits(const scene::Source& source, base::Progress& progress, int finest, double share) {
  if (source.path.starts_with("phantom:")) return 0;
  const std::size_t left = base::machineMemory().left();
  // To open an HDF5 file takes a process: small ones are not opened twice.
  constexpr std::size_t packedAtMost = 20;
  std::error_code ignored;
  if (const auto dataset = hdf5PathOf(source.path);
      finest == 0 && dataset && std::filesystem::file_size(dataset->file, ignored) < left / packedAtMost)
    return 0;
  try {
    std::string reason;
    const std::shared_ptr<const ChunkedVolume> file = openChunked(source, reason, progress);
    if (!file) return 0;
    const int last = coarsestLevel(file->facts());
    int level = std::min(finest, last);
    const auto room = [&] {
      return level == 0 ? left : static_cast<std::size_t>(share * static_cast<double>(left));
    };
    while (level < last && levelBytes(file->facts(), level) > room()) ++level;
    return level;
  } catch (const base::Error&) {
    return 0;
  }
}

Volume readLevel(const scene::Source& source, base::Progress& progress) {
  const std::shared_ptr<const ChunkedVolume> file = opened(source, progress);
  const ChunkedFacts& facts = file->facts();
  if (source.level > coarsestLevel(facts))
    throw base::Error(base::ErrorKind::usage, source.path, "source.level",
                      "level " + std::to_string(source.level) + " is asked for; the coarsest is " +
                          std::to_string(coarsestLevel(facts)));
  const ReadOptions options = readOptions(source);
  const GridGeometry geometry = levelGeometry(facts, source.level);
  ImageHeader header = chunkedHeader(facts, geometry, facts.storedType);
  header.warnings.push_back(levelNote(facts, source.level));
  std::rotate(header.warnings.rbegin(), header.warnings.rbegin() + 1, header.warnings.rend());  // the first
  checkBudget(header, source.path, options);
  const VolumePart part{source.timeStep, source.component};
  const Origin origin = originOf(facts, source.level);
  FileVoxels voxels = withStoredType(facts.storedType, [&](auto zero) -> FileVoxels {
    return readMeans<decltype(zero)>(*file, part, origin, geometry.dims, progress);
  });
  Volume volume = finishVolume(header, std::move(voxels), options, progress);
  volume.coarsestLevel = coarsestLevel(facts);
  takeNames(volume, facts);
  return volume;
}

}  // namespace isolux::volume
