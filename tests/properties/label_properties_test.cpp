// Surfaces of labels: every voxel keeps its side, and the surface lies within half a voxel along each axis of
// a face between a voxel in the set and one that is not; a field that is changed is the field of the new set.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/properties/property_run.h"
#include "tests/support/plain_mask.h"
#include "volume/labels/label_blocks.h"
#include "volume/labels/mask_field.h"

namespace isolux::test {
namespace {

using volume::Grid;

constexpr int kLabels = 5;

// The case's field in five steps; of one seed in three, labels at random.
std::shared_ptr<const Grid> labelsOf(const PropertyCase& made) {
  const Grid field = made.grid();
  const double range = field.maximum() - field.minimum();
  std::vector<std::uint8_t> voxels;
  volume::forEachIn(glm::ivec3(0), field.dims(), [&](glm::ivec3 voxel) {
    const double value = field.value(voxel);
    const double part = made.seed % 3 == 0 ? base::uniformNoise(made.seed, voxels.size())
                        : range > 0.0      ? (value - field.minimum()) / range
                                           : 0.0;
    voxels.push_back(std::isnan(value) ? std::uint8_t{0}
                                       : static_cast<std::uint8_t>(
                                             std::min(static_cast<int>(kLabels * part), kLabels - 1)));
  });
  return std::make_shared<const Grid>(field.geometry(), std::move(voxels));
}

std::vector<int> setOf(std::uint64_t bits) {
  std::vector<int> set;
  for (int label = 0; label < kLabels; ++label)
    if ((bits >> label & 1) != 0) set.push_back(label);
  return set;
}

std::string surfacesOfLabelsKeepTheirPlace(const PropertyCase& made) {
  const std::shared_ptr<const Grid> labels = labelsOf(made);
  base::Progress progress;
  const volume::LabelBlocks blocks(labels, "", progress);
  const std::vector<int> set = setOf(base::hash64(made.seed)), other = setOf(base::hash64(~made.seed));
  const double smoothing = std::max(0.0, 2.2 * base::uniformNoise(made.seed, 7) - 0.2);
  const volume::MaskField mask = makeMask(blocks, set, smoothing, progress);
  const std::string wrong = brokenPromise(*labels, {set.begin(), set.end()}, *mask.grid, made.seed);
  if (!wrong.empty()) return wrong + ", smoothing " + std::to_string(smoothing);
  const volume::MaskField changed = changedMask(mask, blocks, other, progress);
  const volume::MaskField whole = makeMask(blocks, other, smoothing, progress);
  if (changed.grid->hash() != whole.grid->hash() || changed.thin != whole.thin)
    return "a changed field differs, smoothing " + std::to_string(smoothing);
  return {};
}

TEST(LabelProperties, SurfacesOfLabelsKeepTheirPlace) {
  expectHolds("SurfacesOfLabelsKeepTheirPlace", 0.05, surfacesOfLabelsKeepTheirPlace);
}

}  // namespace
}  // namespace isolux::test
