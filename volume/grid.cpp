#include "volume/grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/hash.h"
#include "volume/bricks/brick_source.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/voxels/stored_type.h"

namespace isolux::volume {

namespace {

// An array of this type, without voxels.
VoxelArray emptyArray(VoxelType type) {
  return withStoredType(type, [](auto voxel) { return VoxelArray(std::vector<decltype(voxel)>()); });
}

}  // namespace

Grid::Grid(const GridGeometry& geometry, VoxelArray voxels, double slope, double intercept)
    : Grid(geometry, std::move(voxels), slope, intercept, *std::make_unique<base::Progress>()) {}

Grid::Grid(const GridGeometry& geometry, VoxelArray voxels, double slope, double intercept,
           base::Progress& progress)
    : geometry_(geometry), voxels_(std::move(voxels)), slope_(slope), intercept_(intercept) {
  assert(std::isfinite(slope) && slope != 0.0 && std::isfinite(intercept));
  scanPieces(progress, [](std::size_t, std::size_t) { return true; });
  sumUp();
}

Grid::Grid(const Grid& before, VoxelArray voxels,
           const std::function<bool(std::size_t first, std::size_t end)>& differs, base::Progress& progress)
    : geometry_(before.geometry_),
      voxels_(std::move(voxels)),
      pieces_(before.pieces_),
      slope_(before.slope_),
      intercept_(before.intercept_) {
  assert(voxels_.index() == before.voxels_.index());
  scanPieces(progress, differs);
  sumUp();
}

// Makes +-Inf NaN on the way.
template <class T>
Grid::Piece Grid::scan(std::span<T> voxels) {
  Piece piece;
  T least = std::numeric_limits<T>::max(), most = std::numeric_limits<T>::lowest();
  for (T& v : voxels) {
    if constexpr (std::is_same_v<T, float>) {
      if (!std::isfinite(v)) {
        v = std::numeric_limits<float>::quiet_NaN();
        ++piece.missing;
        continue;
      }
    }
    least = v < least ? v : least;
    most = v > most ? v : most;
  }
  if (piece.missing < voxels.size()) {
    piece.least = static_cast<double>(least);
    piece.most = static_cast<double>(most);
  }
  piece.hash = base::Hasher().addWords(voxels.data(), voxels.size_bytes());
  return piece;
}

template <class Wanted>
void Grid::scanPieces(base::Progress& progress, const Wanted& wanted) {
  std::visit(
      [&]<class T>(std::vector<T>& voxels) {
        assert(voxels.size() == geometry_.voxelCount());
        constexpr std::size_t length = kHashedBytes / sizeof(T);
        pieces_.resize((voxels.size() + length - 1) / length);
        parallelSteps(pieces_.size(), progress, {0.0, 1.0, "scanning voxels"}, [&](std::size_t i) {
          const std::size_t first = i * length, end = std::min(first + length, voxels.size());
          if (wanted(first, end)) pieces_[i] = scan(std::span<T>(voxels).subspan(first, end - first));
        });
      },
      voxels_);
}

void Grid::sumUp() {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::vector<std::uint64_t> hashes;
  held_ = base::machineMemory().count(bytes());
  for (const Piece& piece : pieces_) {
    low = std::min(low, piece.least);
    high = std::max(high, piece.most);
    missing_ += piece.missing;
    hashes.push_back(piece.hash);
  }
  hash_ = hashOf(geometry_, slope_, intercept_, storedType(), hashes);
  if (low <= high) setRange(low, high);
}

std::uint64_t Grid::hashOf(const GridGeometry& geometry, double slope, double intercept, VoxelType stored,
                           std::span<const std::uint64_t> pieces) {
  base::Hasher hash;
  hash.addWords(&geometry.dims, sizeof geometry.dims);
  hash.addWords(&geometry.worldFromVoxel, sizeof geometry.worldFromVoxel);
  const double numbers[] = {slope, intercept, static_cast<double>(emptyArray(stored).index())};
  hash.addWords(numbers, sizeof numbers);
  for (const std::uint64_t piece : pieces) hash.addWords(&piece, sizeof piece);
  return hash;
}

Grid::Grid(const GridGeometry& geometry, const VoxelFacts& facts, double slope, double intercept,
           std::shared_ptr<BrickSource> source)
    : geometry_(geometry),
      voxels_(emptyArray(facts.storedType)),
      slope_(slope),
      intercept_(intercept),
      missing_(facts.missing),
      hash_(facts.hash),
      source_(std::move(source)) {
  assert(source_ && std::isfinite(slope) && slope != 0.0 && std::isfinite(intercept));
  if (missing_ < geometry_.voxelCount()) setRange(facts.storedMinimum, facts.storedMaximum);
}

void Grid::setRange(double storedMinimum, double storedMaximum) {
  storedMinimum_ = storedMinimum;
  storedMaximum_ = storedMaximum;
  minimum_ = valueOfStored(slope_ > 0 ? storedMinimum : storedMaximum);
  maximum_ = valueOfStored(slope_ > 0 ? storedMaximum : storedMinimum);
}

void Grid::throwNotWhole() const {
  throw base::Error(base::ErrorKind::memory, source_->facts().name, "",
                    "its voxels stay in the file, and this needs all of them in memory (" +
                        base::memoryText(bytes()) +
                        "): memory.voxels=memory reads them, where that much memory is there");
}

VoxelType Grid::storedType() const {
  constexpr VoxelType types[] = {VoxelType::int8, VoxelType::uint8, VoxelType::int16, VoxelType::uint16,
                                 VoxelType::float32};
  return types[voxels_.index()];
}

bool Grid::cellHasMissing(glm::ivec3 cell) const {
  for (int i = 0; i < 8; ++i)
    if (std::isnan(stored(extent().corner(cell, i)))) return true;
  return false;
}

double Grid::stored(int x, int y, int z) const {
  if (source_) return source_->stored({x, y, z});
  const std::size_t i = index(x, y, z);
  return std::visit([i](const auto& array) { return static_cast<double>(array[i]); }, voxels_);
}

std::size_t Grid::bytes() const {
  return geometry_.voxelCount() * bytesOf(storedType());
}

}  // namespace isolux::volume
