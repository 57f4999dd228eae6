#include "volume/bricks/level_voxels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <tuple>
#include <type_traits>
#include <utility>

#include <glm/common.hpp>

#include "volume/parallel/parallel_steps.h"
#include "volume/voxels/stored_type.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kPieceBytes = std::size_t{4} << 20;  // of rows that are read at a time

// Voxels of the file's level whose means are made together: whole means, and of chunks that are packed whole
// ones.
glm::ivec3 stepOf(const ChunkedLevel& level, glm::ivec3 factor, std::size_t voxelBytes) {
  const glm::ivec3 dims = level.geometry.dims, chunk = level.cheapParts
                                                           ? glm::ivec3(dims.x, 1, 1)
                                                           : glm::clamp(level.chunkDims, glm::ivec3(1), dims);
  glm::ivec3 step = (chunk + factor - 1) / factor * factor;
  for (const int axis : {1, 2})
    while (step[axis] < dims[axis] && Extent3{step}.count() * voxelBytes < kPieceBytes) step[axis] *= 2;
  return step;
}

// Voxels of a step that are read at a time; where parts are not cheap, the chunk that `at` lies in.
glm::ivec3 pieceOf(const ChunkedLevel& level, glm::ivec3 at, glm::ivec3 left, std::size_t voxelBytes) {
  if (!level.cheapParts) {
    const glm::ivec3 chunk = glm::clamp(level.chunkDims, glm::ivec3(1), level.geometry.dims);
    return glm::min(left, (at / chunk + 1) * chunk - at);
  }
  return wholeRows(left, kPieceBytes / voxelBytes);
}

// Sums over the voxels of a step, by the mean that each belongs to.
class Means {
 public:
  Means(glm::ivec3 low, glm::ivec3 size, glm::ivec3 factor, glm::ivec3 dims)
      : first_(low / factor),
        size_((low + size + factor - 1) / factor - first_),
        factor_(factor),
        dims_(dims) {
    sums_.resize(Extent3{size_}.count(), 0.0);
    weights_.resize(sums_.size(), 0.0);
  }
  template <class T>
  void add(glm::ivec3 low, glm::ivec3 size, const std::vector<T>& voxels) {
    std::size_t i = 0;
    for (int z = low.z; z < low.z + size.z; ++z)
      for (int y = low.y; y < low.y + size.y; ++y) {
        const double weight = weightOf(y, 1) * weightOf(z, 2);
        const std::size_t row = Extent3{size_}.index(0, y / factor_.y - first_.y, z / factor_.z - first_.z);
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
  // Into a level of these dims; `unknown`: as of LevelVoxels, of these means.
  template <class T>
  void write(glm::ivec3 levelDims, std::vector<T>& level, std::vector<std::size_t>& unknown) const {
    std::size_t i = 0;
    forEachIn(first_, first_ + size_, [&](glm::ivec3 voxel) {
      const double mean = sums_[i] / weights_[i];  // NaN where nothing is known
      const std::size_t at = Extent3{levelDims}.index(voxel);
      if constexpr (std::is_floating_point_v<T>)
        level[at] = static_cast<T>(mean);
      else if (weights_[i] > 0.0)
        level[at] = static_cast<T>(std::lround(mean));
      else
        unknown.push_back(at);
      ++i;
    });
  }

 private:
  // How often a voxel counts: the last of an axis stands for those that its mean lacks.
  double weightOf(int at, int axis) const {
    return at + 1 == dims_[axis] ? static_cast<double>(factor_[axis] - at % factor_[axis]) : 1.0;
  }

  glm::ivec3 first_, size_, factor_, dims_;
  std::vector<double> sums_, weights_;
};

// The voxels of a box in float32, those of `damaged` missing.
template <class T>
std::vector<float> withMissing(const std::vector<T>& voxels, glm::ivec3 low, glm::ivec3 size,
                               const std::vector<DamagedPart>& damaged) {
  std::vector<float> known(voxels.begin(), voxels.end());
  for (const DamagedPart& part : damaged)
    for (int z = 0; z < part.size.z; ++z)
      for (int y = 0; y < part.size.y; ++y) {
        const std::size_t row = Extent3{size}.index(part.low + glm::ivec3(0, y, z) - low);
        std::fill_n(known.begin() + static_cast<std::ptrdiff_t>(row), part.size.x,
                    std::numeric_limits<float>::quiet_NaN());
      }
  return known;
}

template <class T>
LevelVoxels readMeans(const ChunkedVolume& file, VolumePart part, const LevelOrigin& origin, glm::ivec3 dims,
                      bool around, base::Progress& progress) {
  const ChunkedLevel& level = file.facts().levels[origin.fileLevel];
  const glm::ivec3 from = level.geometry.dims, step = stepOf(level, origin.factor, sizeof(T));
  const Extent3 steps{(from + step - 1) / step};
  LevelVoxels read;
  std::vector<T> voxels;
  resizeStoppably(voxels, Extent3{dims}.count(), progress);
  std::mutex mutex;  // of what is found of damage
  parallelSteps(steps.count(), progress, {0.0, 1.0, "reading"}, [&](std::size_t i) {
    const glm::ivec3 low = step * steps.at(i), behind = glm::min(low + step, from);
    Means means(low, behind - low, origin.factor, from);
    std::vector<T> piece;
    std::vector<DamagedPart> damaged;
    glm::ivec3 size;
    for (glm::ivec3 at = low; at.z < behind.z; at.z += size.z)
      for (at.y = low.y; at.y < behind.y; at.y += size.y)
        for (at.x = low.x; at.x < behind.x; at.x += size.x) {
          if (progress.stopRequested()) return;
          size = pieceOf(level, at, behind - at, sizeof(T));
          piece.resize(Extent3{size}.count());
          const auto bytes = std::as_writable_bytes(std::span(piece));
          if (around)
            readAround(file, part, origin.fileLevel, at, size, bytes, damaged);
          else
            file.read(part, origin.fileLevel, at, size, bytes);
          if (damaged.empty()) {
            means.add(at, size, piece);
          } else {
            means.add(at, size, withMissing(piece, at, size, damaged));
            const std::lock_guard lock(mutex);
            for (DamagedPart& one : std::exchange(damaged, {}))
              recordDamage(file.facts().name, std::move(one), read.damaged);
          }
        }
    std::vector<std::size_t> unknown;
    means.write(dims, voxels, unknown);
    const std::lock_guard lock(mutex);
    read.unknown.insert(read.unknown.end(), unknown.begin(), unknown.end());
  });
  // Independent of which thread was first.
  std::ranges::sort(read.damaged, [](const DamagedPart& a, const DamagedPart& b) {
    return std::tie(a.low.z, a.low.y, a.low.x) < std::tie(b.low.z, b.low.y, b.low.x);
  });
  std::ranges::sort(read.unknown);
  read.voxels = std::move(voxels);
  return read;
}

}  // namespace

LevelVoxels readLevelVoxels(const ChunkedVolume& file, VolumePart part, const LevelOrigin& origin,
                            glm::ivec3 dims, bool around, base::Progress& progress) {
  return withStoredType(file.facts().storedType, [&](auto zero) {
    return readMeans<decltype(zero)>(file, part, origin, dims, around, progress);
  });
}

std::vector<float> withMissing(const LevelVoxels& level, base::Progress& progress) {
  std::vector<float> known;
  std::visit(
      [&](const auto& voxels) {
        resizeStoppably(known, voxels.size(), progress);
        std::copy(voxels.begin(), voxels.end(), known.begin());
      },
      level.voxels);
  for (const std::size_t at : level.unknown) known[at] = std::numeric_limits<float>::quiet_NaN();
  return known;
}

}  // namespace isolux::volume
