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

namespace isolux::volume {

namespace {

constexpr int kColumns = 4;             // of a cell, along y and along z
constexpr double kUnit = 4294967296.0;  // 2^32: parts of cells are summed as integers, in any order
constexpr std::uint64_t kWholeCell = 1ull << 32;

struct Sums {
  std::uint64_t volume = 0, error = 0, voxels = 0;  // 2^-32 cells; voxels
};

// A row's sums, handed on whenever another piece comes.
class Tally {
 public:
  explicit Tally(std::vector<Sums>& all) : all_(all) {}
  ~Tally() { handOn(); }
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;

  Sums& of(std::uint32_t piece) {
    if (piece != piece_) handOn();
    piece_ = piece;
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
    add(sums.error, sums_.error);
    add(sums.voxels, sums_.voxels);
    sums_ = {};
  }
  std::vector<Sums>& all_;
  std::uint32_t piece_ = Pieces::kNone;
  Sums sums_;
};

// The length of the part of [0, 1] where a + (b - a) x >= 0.
float lengthInside(float a, float b) {
  constexpr float tiny = 1e-30f;  // against 0 / 0
  return 1.0f - (std::max(-a, 0.0f) + std::max(-b, 0.0f)) / (std::abs(a) + std::abs(b) + tiny);
}

// Values on a face x = const of the cell, at the corners of the columns.
using ColumnCorners = std::array<float, std::size_t{kColumns + 1} * (kColumns + 1)>;
ColumnCorners columnCorners(float at00, float at10, float at01, float at11) {
  ColumnCorners values;
  for (int z = 0; z <= kColumns; ++z) {
    const float w = static_cast<float>(z) / kColumns;
    const float low = at00 + w * (at01 - at00), high = at10 + w * (at11 - at10);
    for (int y = 0; y <= kColumns; ++y)
      values[static_cast<std::size_t>(z * (kColumns + 1) + y)] =
          low + static_cast<float>(y) / kColumns * (high - low);
  }
  return values;
}

// The least and the greatest of a column's corners, of all columns.
struct ColumnBounds {
  std::array<float, std::size_t{kColumns} * kColumns> least, most;
  explicit ColumnBounds(const ColumnCorners& corners) {
    for (std::size_t z = 0; z < kColumns; ++z)
      for (std::size_t y = 0; y < kColumns; ++y) {
        const float* const at = &corners[z * (kColumns + 1) + y];
        const float a = at[0], b = at[1], c = at[kColumns + 1], d = at[kColumns + 2];
        least[z * kColumns + y] = std::min(std::min(a, b), std::min(c, d));
        most[z * kColumns + y] = std::max(std::max(a, b), std::max(c, d));
      }
  }
};

std::uint64_t units(double cells) {
  return static_cast<std::uint64_t>(cells * kUnit + 0.5);
}

}  // namespace

CellPart partInside(const std::array<float, 8>& d) {
  const ColumnBounds near(columnCorners(d[0], d[2], d[4], d[6])), far(columnCorners(d[1], d[3], d[5], d[7]));
  float least = 0.0f, most = 0.0f;
  for (std::size_t i = 0; i < near.least.size(); ++i) {
    least += lengthInside(near.least[i], far.least[i]);
    most += lengthInside(near.most[i], far.most[i]);
  }
  constexpr float each = 0.5f / (kColumns * kColumns), rounding = 1e-5f;
  return {each * (least + most), each * (most - least) + rounding};
}

namespace {

// The sizes of the pieces in a row of blocks.
class RowSizes {
 public:
  RowSizes(const Pieces& pieces, std::vector<Sums>& all) : pieces_(pieces), tally_(all) {}

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

  void add(std::uint32_t piece, double part, double error) {
    Sums& sums = tally_.of(piece);
    sums.volume += units(part);
    sums.error += units(error);
  }

  // All inside corners are of one piece: that of the first.
  void addCrossed(glm::ivec3 b, const PieceBlocks::View& block, const BlockCells::Slice& slice,
                  glm::ivec3 cell, const std::array<float, 8>& depths) {
    std::size_t corner = 0;
    while ((slice.corners[corner] >> (cell.x + 8 * cell.y) & 1u) == 0) ++corner;
    const CellPart part = partInside(depths);
    const auto bits = static_cast<int>(corner);
    const glm::ivec3 at = cell + glm::ivec3(bits & 1, bits >> 1 & 1, bits >> 2);
    const bool within = glm::all(glm::lessThan(at, glm::ivec3(kPieceBlock)));
    add(within ? pieces_.ofNode(block.nodeOf(at)) : pieceOf(kPieceBlock * b + at), part.part, part.error);
  }

  std::uint32_t pieceOf(glm::ivec3 voxel) const {
    return pieces_.ofVoxel(glm::min(voxel, pieces_.blocks().voxelDims() - 1));
  }

  // A column of the cell is given to the piece that its middle leads to; what that errs by is no more than
  // the cell's whole part.
  void addAmbiguous(glm::ivec3 cell, const std::array<float, 8>& depths) {
    std::array<std::uint32_t, 8> piece;
    std::uint32_t first = Pieces::kNone;
    bool several = false;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const auto bits = static_cast<int>(corner);
      piece[corner] = depths[corner] >= 0.0f ? pieceOf(cell + glm::ivec3(bits & 1, bits >> 1 & 1, bits >> 2))
                                             : Pieces::kNone;
      if (piece[corner] == Pieces::kNone) continue;
      if (first == Pieces::kNone) first = piece[corner];
      several = several || piece[corner] != first;
    }
    const CellPart part = partInside(depths);
    if (!several) return add(first, part.part, part.error);
    CellCorners values;
    std::copy(depths.begin(), depths.end(), values.begin());
    std::array<double, 8> share{};  // of the corners that columns lead to
    for (int z = 0; z < kColumns; ++z)
      for (int y = 0; y < kColumns; ++y) {
        const glm::dvec3 middle(0.0, (y + 0.5) / kColumns, (z + 0.5) / kColumns);
        const double a = trilinear(values, middle), b = trilinear(values, {1.0, middle.y, middle.z});
        if (a < 0.0 && b < 0.0) continue;
        const int corner = cornerAbove(values, {a >= b ? 0.0 : 1.0, middle.y, middle.z});
        share[static_cast<std::size_t>(corner)] +=
            static_cast<double>(lengthInside(static_cast<float>(a), static_cast<float>(b))) /
            (kColumns * kColumns);
      }
    for (std::size_t corner = 0; corner < 8; ++corner)
      if (piece[corner] != Pieces::kNone)
        add(piece[corner], share[corner], static_cast<double>(part.part + part.error));
  }

  const Pieces& pieces_;
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
    result[i] = {static_cast<double>(sums[i].volume) / kUnit * cellMm3,
                 static_cast<double>(sums[i].error) / kUnit * cellMm3, sums[i].voxels};
  return result;
}

}  // namespace isolux::volume
