#include "volume/pieces/piece_sizes.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <variant>

#include <glm/matrix.hpp>

#include "volume/parallel_steps.h"
#include "volume/pieces/block_cells.h"
#include "volume/pieces/cell_pieces.h"
#include "volume/skip/row_lanes.h"

namespace isolux::volume {

namespace {

constexpr int kColumns = 4;             // of a cell, along y and along z
constexpr double kUnit = 4294967296.0;  // 2^32: parts of cells are summed as integers, in any order
constexpr std::uint64_t kWholeCell = 1ull << 32;

struct Sums {
  std::uint64_t volume = 0, voxels = 0;  // 2^-32 cells; voxels
};

// A row's sums, handed on whenever another piece comes.
class Tally {
 public:
  explicit Tally(std::vector<Sums>& all) : all_(all) {}
  ~Tally() { handOn(); }
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;

  Sums& of(std::uint32_t piece) {
    if (piece != piece_) {
      handOn();
      piece_ = piece;
    }
    return sums_;
  }

 private:
  void handOn() {
    if (piece_ == Pieces::kNone) return;
    Sums& sums = all_[piece_];
    const auto add = [](std::uint64_t& to, std::uint64_t amount) {
      if (amount != 0) std::atomic_ref(to).fetch_add(amount, std::memory_order_relaxed);
    };
    add(sums.volume, sums_.volume);
    add(sums.voxels, sums_.voxels);
    sums_ = {};
  }
  std::vector<Sums>& all_;
  std::uint32_t piece_ = Pieces::kNone;
  Sums sums_;
};

// The length of the part of [0, 1] where a + (b - a) x >= 0.
FourFloats lengthInside(FourFloats a, FourFloats b) {
  constexpr float tiny = 1e-30f;  // against 0 / 0
  const FourFloats none = {};
  const FourFloats outsideA = a < 0.0f ? -a : none, outsideB = b < 0.0f ? -b : none;
  const FourFloats outside = outsideA + outsideB;
  return 1.0f - outside / ((a + b) + 2.0f * outside + tiny);  // |a| + |b|
}

std::uint64_t units(float cells) {
  return static_cast<std::uint64_t>(static_cast<double>(cells) * kUnit + 0.5);
}

}  // namespace

float partInside(const std::array<float, 8>& d) {
  const FourFloats y = {0.125f, 0.375f, 0.625f, 0.875f};
  FourFloats sum = {};
  for (int i = 0; i < kColumns; ++i) {
    const float z = (static_cast<float>(i) + 0.5f) / kColumns;
    const auto along = [&](std::size_t x) {  // at the columns' end x
      const float low = d[x] + z * (d[x + 4] - d[x]), high = d[x + 2] + z * (d[x + 6] - d[x + 2]);
      return low + y * (high - low);
    };
    sum += lengthInside(along(0), along(1));
  }
  return (sum[0] + sum[1] + sum[2] + sum[3]) / (kColumns * kColumns);
}

std::array<double, 8> cornerShares(const CellCorners& values) {
  std::array<double, 8> shares{};
  for (int z = 0; z < kColumns; ++z)
    for (int y = 0; y < kColumns; ++y) {
      const glm::dvec3 near(0.0, (y + 0.5) / kColumns, (z + 0.5) / kColumns), far(1.0, near.y, near.z);
      const double a = trilinear(values, near), b = trilinear(values, far), most = std::max(a, b);
      if (most < 0.0) continue;
      const double length = std::min(a, b) >= 0.0 ? 1.0 : most / std::abs(a - b);
      shares[static_cast<std::size_t>(cornerAbove(values, a >= b ? near : far))] +=
          length / (kColumns * kColumns);
    }
  return shares;
}

namespace {

// The sizes of the pieces in a row of blocks.
class RowSizes {
 public:
  RowSizes(const Pieces& pieces, std::vector<Sums>& all)
      : pieces_(pieces), anyMissing_(pieces.grid().missingCount() > 0), tally_(all) {}

  void countVoxels(glm::ivec3 b) {
    const PieceBlocks& blocks = pieces_.blocks();
    const PieceBlocks::View block = blocks.view(b);
    if (!block.bits) return;
    if (blocks.inside(blocks.index(b))) {
      const glm::ivec3 size = glm::min(blocks.voxelDims() - b * kPieceBlock, kPieceBlock);
      tally_.of(pieces_.ofNode(block.firstNode)).voxels +=
          static_cast<std::uint64_t>(size.x * size.y * size.z);
      return;
    }
    for (int z = 0; z < 8; ++z) {
      std::uint64_t bits = (*block.bits)[static_cast<std::size_t>(z)];
      if (!block.labels)
        tally_.of(pieces_.ofNode(block.firstNode)).voxels += static_cast<std::uint64_t>(std::popcount(bits));
      else
        for (; bits != 0; bits &= bits - 1) ++tally_.of(pieceAt(block, bits, z)).voxels;
    }
  }

  // Of a block whose cells are all whole, or all empty.
  void addUncrossed(glm::ivec3 b) {
    const PieceBlocks::View block = pieces_.blocks().view(b);
    if (!block.bits) return;
    const glm::ivec3 cells =
        glm::max(glm::min(pieces_.blocks().voxelDims() - 1 - b * kPieceBlock, kPieceBlock), 0);
    tally_.of(pieces_.ofNode(block.firstNode)).volume +=
        static_cast<std::uint64_t>(cells.x * cells.y * cells.z) * kWholeCell;
  }

  void addCells(glm::ivec3 b, const BlockCells& cells) {
    const PieceBlocks::View block = pieces_.blocks().view(b);
    for (int z = 0; z < cells.count().z; ++z) {
      const BlockCells::Slice slice = cells.slice(z);
      addWhole(block, slice.whole, z);
      const std::uint64_t ambiguous = slice.ambiguous();
      for (std::uint64_t left = slice.crossed; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const glm::ivec3 cell(bit % 8, bit / 8, z);
        const std::array<float, 8> depths = cells.depths(cell);
        if (std::any_of(depths.begin(), depths.end(), [](float depth) { return std::isnan(depth); }))
          continue;
        if ((ambiguous >> bit & 1u) == 0)
          addCrossed(b, block, slice, cell, depths);
        else
          addAmbiguous(kPieceBlock * b + cell, depths);
      }
    }
  }

 private:
  std::uint32_t pieceAt(const PieceBlocks::View& block, std::uint64_t bits, int z) const {
    const int bit = std::countr_zero(bits);
    return pieces_.ofNode(block.nodeOf({bit % 8, bit / 8, z}));
  }

  void addWhole(const PieceBlocks::View& block, std::uint64_t whole, int z) {
    if (whole == 0) return;
    if (!block.labels)
      tally_.of(pieces_.ofNode(block.firstNode)).volume +=
          static_cast<std::uint64_t>(std::popcount(whole)) * kWholeCell;
    else
      for (; whole != 0; whole &= whole - 1) tally_.of(pieceAt(block, whole, z)).volume += kWholeCell;
  }

  void add(std::uint32_t piece, float part) { tally_.of(piece).volume += units(part); }

  // All inside corners are of one piece: that of the first.
  void addCrossed(glm::ivec3 b, const PieceBlocks::View& block, const BlockCells::Slice& slice,
                  glm::ivec3 cell, const std::array<float, 8>& depths) {
    std::size_t corner = 0;
    while ((slice.corners[corner] >> (cell.x + 8 * cell.y) & 1u) == 0) ++corner;
    const auto bits = static_cast<int>(corner);
    const glm::ivec3 at = cell + glm::ivec3(bits & 1, bits >> 1 & 1, bits >> 2);
    const bool within = glm::all(glm::lessThan(at, glm::ivec3(kPieceBlock)));
    add(within ? pieces_.ofNode(block.nodeOf(at)) : pieceOf(kPieceBlock * b + at), partInside(depths));
  }

  std::uint32_t pieceOf(glm::ivec3 voxel) const {
    return pieces_.ofVoxel(glm::min(voxel, pieces_.blocks().voxelDims() - 1));
  }

  void addAmbiguous(glm::ivec3 cell, const std::array<float, 8>& depths) {
    std::array<std::uint32_t, 8> piece;
    CellCorners values;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const auto bits = static_cast<int>(corner);
      values[corner] = depths[corner];
      piece[corner] = pieceOf(cell + glm::ivec3(bits & 1, bits >> 1 & 1, bits >> 2));
    }
    const std::array<double, 8> shares = cornerShares(values);
    for (std::size_t corner = 0; corner < 8; ++corner)
      if (shares[corner] > 0.0) add(piece[corner], static_cast<float>(shares[corner]));
  }

  const Pieces& pieces_;
  bool anyMissing_;
  Tally tally_;
};

}  // namespace

std::vector<Piece> pieceSizes(const Pieces& pieces, std::size_t count, base::Progress& progress) {
  const PieceBlocks& blocks = pieces.blocks();
  const glm::ivec3 dims = blocks.dims();
  std::vector<Sums> sums(count);
  const auto measureRow = [&](const auto& voxels, std::size_t row) {
    RowSizes sizes(pieces, sums);
    BlockCells cells;
    glm::ivec3 b(0, static_cast<int>(row) % dims.y, static_cast<int>(row) / dims.y);
    for (; b.x < dims.x; ++b.x) {
      sizes.countVoxels(b);
      if (!blocks.crossed(blocks.index(b))) {
        sizes.addUncrossed(b);
      } else if (pieces.hasVolume()) {
        cells.load(voxels, blocks.voxelDims(), b, pieces.level());
        sizes.addCells(b, cells);
      }
    }
  };
  std::visit(
      [&](const auto& voxels) {
        parallelSteps(static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z), progress,
                      {0.6, 1.0, "measuring pieces"}, [&](std::size_t row) { measureRow(voxels, row); });
      },
      pieces.grid().voxels());
  const double cellMm3 = std::abs(glm::determinant(glm::dmat3(pieces.grid().geometry().worldFromVoxel)));
  std::vector<Piece> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = {static_cast<double>(sums[i].volume) / kUnit * cellMm3, sums[i].voxels};
  return result;
}

}  // namespace isolux::volume
