#include "volume/pieces/piece_blocks.h"

#include <algorithm>

#include "volume/parallel/parallel_steps.h"
#include "volume/skip/row_lanes.h"

namespace isolux::volume {

namespace {

constexpr VoxelBits allVoxels() {
  VoxelBits bits{};
  bits.fill(~std::uint64_t{0});
  return bits;
}
constexpr VoxelBits kAllVoxels = allVoxels();

template <class T>
unsigned insideBits(const T* row, int count, InsideLevel level) {
  unsigned bits = 0;
  if (count == kPieceBlock) {
    const FourFloats near = fourOf(row), far = fourOf(row + 4);
    return level.high ? eightBits(near >= level.level, far >= level.level)
                      : eightBits(near <= level.level, far <= level.level);
  }
  for (int x = 0; x < count; ++x) bits |= static_cast<unsigned>(level.holds(static_cast<float>(row[x]))) << x;
  return bits;
}

}  // namespace

base::MemoryBudget::Held reserveForPieces(std::size_t bytes) {
  return base::machineMemory().reserve(bytes, "the connected components",
                                       "pieces.keep=0 and pieces.smallest=0 need none");
}

PieceBlocks::PieceBlocks(const Grid& grid, const MinMaxBlocks& blocks, InsideLevel level,
                         base::Progress& progress)
    : level_(level), voxelDims_(grid.dims()), dims_((grid.dims() + kPieceBlock - 1) / kPieceBlock) {
  const Extent3 extent{dims_};
  held_ = reserveForPieces(extent.count() * (sizeof(Block) + 1));
  blocks_.resize(extent.count());
  crossed_.resize(extent.count());
  rows_.resize(extent.rows());
  const bool anyMissing = grid.missingCount() > 0;
  grid.visit([&](const auto& voxels) {
    parallelSteps(extent.rows(), progress, {0.0, 0.3, "finding pieces"},
                  [&](std::size_t row) { fillRow(voxels, blocks, anyMissing, row); });
  });
  numberNodes();
  held_.add(reserveForPieces(bytes() - held_.bytes()));
}

std::size_t PieceBlocks::bytes() const {
  std::size_t sum = blocks_.size() * (sizeof(Block) + 1);
  for (const Row& row : rows_)
    sum += row.mixed.size() * sizeof(Mixed) + row.labels.size() * sizeof(VoxelLabels);
  return sum;
}

PieceBlocks::View PieceBlocks::view(glm::ivec3 b) const {
  const Block& block = blocks_[index(b)];
  if (block.mixed == kOutside) return {};
  if (block.mixed == kInside) return {block.firstNode, 1, &kAllVoxels, nullptr};
  const Row& row = rows_[static_cast<std::size_t>(b.z * dims_.y + b.y)];
  const Mixed& mixed = row.mixed[static_cast<std::size_t>(block.mixed)];
  return {block.firstNode, mixed.components, &mixed.bits,
          mixed.labels < 0 ? nullptr : &row.labels[static_cast<std::size_t>(mixed.labels)]};
}

template <class T>
void PieceBlocks::fillRow(const std::vector<T>& voxels, const MinMaxBlocks& bounds, bool anyMissing,
                          std::size_t rowIndex) {
  Row& row = rows_[rowIndex];
  const bool flat = bounds.count() == 0;  // an axis of one voxel
  for (glm::ivec3 b = Extent3{dims_}.firstOfRow(rowIndex); b.x < dims_.x; ++b.x) {
    Block& block = blocks_[index(b)];
    // The bounds of a block's cells hold its voxels, and those of a last layer that begins no cell.
    const std::size_t cells = flat ? 0 : bounds.index(glm::min(b, bounds.dims() - 1));
    const bool noneInside =
        !flat && !level_.holds(level_.high ? bounds.maximum(cells) : bounds.minimum(cells));
    const bool allInside =
        !flat && !anyMissing && level_.holds(level_.high ? bounds.minimum(cells) : bounds.maximum(cells));
    if (noneInside) continue;
    if (allInside) {
      block.mixed = kInside;
      block.firstNode = row.nodes++;
      continue;
    }
    crossed_[index(b)] = 1;
    classify(read(voxels, b), b, block, row);
  }
}

template <class T>
VoxelBits PieceBlocks::read(const std::vector<T>& voxels, glm::ivec3 block) const {
  const glm::ivec3 first = block * kPieceBlock, count = glm::min(voxelDims_ - first, kPieceBlock);
  VoxelBits bits{};
  for (int z = 0; z < count.z; ++z)
    for (int y = 0; y < count.y; ++y) {
      const T* const at = voxels.data() + Extent3{voxelDims_}.index(first + glm::ivec3(0, y, z));
      bits[static_cast<std::size_t>(z)] |= std::uint64_t{insideBits(at, count.x, level_)} << (8 * y);
    }
  return bits;
}

std::uint64_t PieceBlocks::fullWord(glm::ivec3 block) const {
  const glm::ivec3 count = glm::min(voxelDims_ - block * kPieceBlock, kPieceBlock);
  const std::uint64_t row = (1u << count.x) - 1u;
  std::uint64_t word = 0;
  for (int y = 0; y < count.y; ++y) word |= row << (8 * y);
  return word;
}

void PieceBlocks::classify(const VoxelBits& bits, glm::ivec3 b, Block& result, Row& row) {
  std::uint64_t any = 0;
  for (const std::uint64_t word : bits) any |= word;
  if (any == 0) return;
  result.firstNode = row.nodes;
  const std::uint64_t full = fullWord(b);
  const auto depth = std::min(voxelDims_.z - b.z * kPieceBlock, kPieceBlock);
  if (std::all_of(bits.begin(), bits.begin() + depth, [full](std::uint64_t word) { return word == full; })) {
    result.mixed = kInside;
    ++row.nodes;
    return;
  }
  VoxelLabels labels;
  Mixed mixed{bits};
  mixed.components = labelVoxels(bits, labels);
  if (mixed.components > 1) {
    mixed.labels = static_cast<std::int32_t>(row.labels.size());
    row.labels.push_back(labels);
  }
  row.nodes += static_cast<std::uint32_t>(mixed.components);
  result.mixed = static_cast<std::int32_t>(row.mixed.size());
  row.mixed.push_back(mixed);
}

// Rows after each other.
void PieceBlocks::numberNodes() {
  std::uint64_t before = 0;
  const auto length = static_cast<std::size_t>(dims_.x);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for (std::size_t i = row * length; i < (row + 1) * length; ++i)
      if (blocks_[i].mixed != kOutside) blocks_[i].firstNode += static_cast<std::uint32_t>(before);
    before += rows_[row].nodes;
  }
  if (before >= kNoLabel)
    throw base::Error(
        base::ErrorKind::memory, "", "",
        "too many component labels (limit 4 294 967 294); smooth the data or change the isovalue");
  nodes_ = static_cast<std::uint32_t>(before);
}

}  // namespace isolux::volume
