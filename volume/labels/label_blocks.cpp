#include "volume/labels/label_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr int kLabelBlock = LabelBlocks::kSize;

struct LabelTally {
  std::size_t voxels = 0;
  glm::ivec3 low{std::numeric_limits<int>::max()}, high{-1};
};

// The labels of a row of blocks along x, by their stored values; those of the missing voxels, NaN, are not
// tallied.
struct LabelRow {
  std::vector<std::uint32_t> counts;  // of labels of each block
  std::vector<float> stored;          // block after block
  std::unordered_map<float, LabelTally> tallies;
};

// Distinct values of one block and how many voxels have each.
class BlockValues {
 public:
  void clear() { values_.clear(); }
  void add(float stored, std::size_t voxels) {
    const auto same = [&](const std::pair<float, std::size_t>& value) {
      return value.first == stored || (std::isnan(stored) && std::isnan(value.first));
    };
    const auto found = std::find_if(values_.begin(), values_.end(), same);
    if (found == values_.end())
      values_.emplace_back(stored, voxels);
    else
      found->second += voxels;
  }
  const std::vector<std::pair<float, std::size_t>>& list() const { return values_; }

 private:
  std::vector<std::pair<float, std::size_t>> values_;
};

// Whether the 8 x 8 x 8 voxels from `first` on are equal.
template <class T>
bool isUniform(const T* first, std::size_t row, std::size_t slice) {
  for (int x = 1; x < kLabelBlock; ++x)
    if (!(first[x] == first[0])) return false;
  for (std::size_t z = 0; z < kLabelBlock; ++z)
    for (std::size_t y = 0; y < kLabelBlock; ++y)
      if (std::memcmp(first + z * slice + y * row, first, kLabelBlock * sizeof(T)) != 0) return false;
  return true;
}

template <class T>
void addVoxels(const T* voxels, const Extent3& extent, glm::ivec3 low, glm::ivec3 end, BlockValues& values) {
  const auto same = [](T a, T b) {
    if constexpr (std::is_floating_point_v<T>) return a == b || (std::isnan(a) && std::isnan(b));
    return a == b;
  };
  T last = voxels[extent.index(low)];
  std::size_t run = 0;
  for (int z = low.z; z < end.z; ++z)
    for (int y = low.y; y < end.y; ++y) {
      const T* const row = voxels + extent.index(0, y, z);
      for (int x = low.x; x < end.x; ++x) {
        if (!same(row[x], last)) {
          values.add(static_cast<float>(last), run);
          last = row[x];
          run = 0;
        }
        ++run;
      }
    }
  values.add(static_cast<float>(last), run);
}

template <class T>
LabelRow labelsOfRow(const std::vector<T>& voxels, const Extent3& extent, int blockY, int blockZ) {
  LabelRow row;
  BlockValues values;
  for (int x = 0; x < extent.dims.x; x += kLabelBlock) {
    const glm::ivec3 low(x, kLabelBlock * blockY, kLabelBlock * blockZ),
        end = glm::min(low + kLabelBlock, extent.dims);
    values.clear();
    const T* const first = voxels.data() + extent.index(low);
    if (end == low + kLabelBlock && isUniform(first, extent.row(), extent.slice()))
      values.add(static_cast<float>(*first), kLabelBlock * kLabelBlock * kLabelBlock);
    else
      addVoxels(voxels.data(), extent, low, end, values);
    row.counts.push_back(static_cast<std::uint32_t>(values.list().size()));
    for (const auto& [stored, count] : values.list()) {
      row.stored.push_back(stored);
      if (std::isnan(stored)) continue;
      LabelTally& tally = row.tallies[stored];
      tally.voxels += count;
      tally.low = glm::min(tally.low, low);
      tally.high = glm::max(tally.high, end - 1);
    }
  }
  return row;
}

int labelOf(const Grid& grid, float stored, const std::string& file) {
  const double value = grid.valueOfStored(static_cast<double>(stored));
  if (value != std::floor(value))
    base::throwInput(file, "",
                     "its values are no labels: " + base::shortText(value) + " is not a whole number");
  if (!(std::abs(value) <= std::numeric_limits<int>::max()))
    base::throwInput(file, "", "label " + base::shortText(value) + " is too large; the limit is 2147483647");
  return static_cast<int>(value);
}

std::vector<LabelExtent> mergedLabels(const Grid& grid, const std::vector<LabelRow>& rows,
                                      const std::string& file) {
  std::map<float, LabelTally> all;
  for (const LabelRow& row : rows)
    for (const auto& [stored, tally] : row.tallies) {
      LabelTally& sum = all[stored];
      sum.voxels += tally.voxels;
      sum.low = glm::min(sum.low, tally.low);
      sum.high = glm::max(sum.high, tally.high);
      if (all.size() > LabelBlocks::kMostLabels)
        base::throwInput(file, "", "its values are no labels: there are more than 65535 different ones");
    }
  std::vector<LabelExtent> list;
  for (const auto& [stored, tally] : all)
    list.push_back({labelOf(grid, stored, file), stored, tally.voxels, tally.low, tally.high});
  std::ranges::sort(list, {}, &LabelExtent::label);  // a negative slope turns the order round
  return list;
}

}  // namespace

LabelBlocks::LabelBlocks(std::shared_ptr<const Grid> grid, const std::string& file, base::Progress& progress)
    : grid_(std::move(grid)), blocks_{(grid_->dims() + kLabelBlock - 1) / kLabelBlock} {
  std::vector<LabelRow> rows(blocks_.rows());
  grid_->visit([&](const auto& voxels) {
    parallelSteps(rows.size(), progress, {0.0, 1.0, "finding labels"}, [&](std::size_t row) {
      const glm::ivec3 first = blocks_.firstOfRow(row);
      rows[row] = labelsOfRow(voxels, grid_->extent(), first.y, first.z);
    });
  });
  list_ = mergedLabels(*grid_, rows, file);

  std::size_t count = 0;
  for (const LabelRow& row : rows) count += row.stored.size();
  held_ = base::machineMemory().reserve(
      count * sizeof(std::uint16_t) + (blocks_.count() + 1) * sizeof(std::uint32_t), "the lists of labels",
      "a volume with fewer voxels needs less");
  std::unordered_map<float, std::uint16_t> indexOf;
  for (std::size_t i = 0; i < list_.size(); ++i) indexOf[list_[i].stored] = static_cast<std::uint16_t>(i);
  begins_.reserve(blocks_.count() + 1);
  indices_.reserve(count);
  for (const LabelRow& row : rows) {
    auto stored = row.stored.begin();
    for (const std::uint32_t labels : row.counts) {
      begins_.push_back(static_cast<std::uint32_t>(indices_.size()));
      for (std::uint32_t i = 0; i < labels; ++i, ++stored)
        indices_.push_back(std::isnan(*stored) ? kMissing : indexOf.at(*stored));
    }
  }
  begins_.push_back(static_cast<std::uint32_t>(indices_.size()));
}

}  // namespace isolux::volume
