// Labels of a volume of 512^3: lists of them, mask fields from nothing and after a change of the set.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base/random.h"
#include "bench/bench.h"
#include "volume/labels/label_blocks.h"
#include "volume/labels/mask_field.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::bench {
namespace {

constexpr int kSize = 512, kLabels = 105;

// A ball that is divided among the nearest of 105 points in it.
std::shared_ptr<const volume::Grid> dividedBall(base::Progress& progress) {
  const double radius = 0.47 * kSize;
  const glm::dvec3 centre(0.5 * (kSize - 1));
  std::vector<glm::dvec3> points;
  for (std::uint64_t i = 0; points.size() < kLabels; ++i) {
    const glm::dvec3 at(base::uniformNoise(1, 3 * i), base::uniformNoise(1, 3 * i + 1),
                        base::uniformNoise(1, 3 * i + 2));
    if (glm::length(2.0 * at - 1.0) < 0.9) points.push_back(centre + (2.0 * at - 1.0) * radius);
  }
  const auto geometry = volume::GridGeometry::make(glm::ivec3(kSize), glm::dvec3(1.0));
  std::vector<std::uint8_t> voxels(geometry.voxelCount());
  volume::parallelSteps(static_cast<std::size_t>(kSize) * kSize, progress, {}, [&](std::size_t row) {
    const glm::ivec3 first = geometry.extent().firstOfRow(row);
    for (int x = 0; x < kSize; ++x) {
      const glm::dvec3 at(x, first.y, first.z);
      if (glm::length(at - centre) >= radius) continue;
      const auto nearest =
          std::ranges::min_element(points, {}, [&](const glm::dvec3& p) { return glm::dot(p - at, p - at); });
      voxels[geometry.extent().index(x, first.y, first.z)] =
          static_cast<std::uint8_t>(1 + (nearest - points.begin()));
    }
  });
  return std::make_shared<const volume::Grid>(geometry, std::move(voxels));
}

void run() {
  base::Progress progress;
  const auto grid = dividedBall(progress);
  const volume::LabelBlocks blocks(grid, "", progress);
  std::vector<int> all, half;
  for (int label = 1; label <= kLabels; ++label) {
    all.push_back(label);
    if (label % 2 == 1) half.push_back(label);
  }
  std::vector<int> more = half;
  more.push_back(2);
  for (const double smoothing : {0.0, 1.0, 2.0}) {
    const volume::MaskField mask = makeMask(blocks, half, smoothing, progress);
    std::printf(" smoothing %g: %zu thin voxels of half of the labels\n", smoothing, mask.thinVoxels());
    const auto times = medians({[&] { volume::LabelBlocks(grid, "", progress); },
                                [&] { makeMask(blocks, all, smoothing, progress); },
                                [&] { makeMask(blocks, half, smoothing, progress); },
                                [&] { changedMask(mask, blocks, more, progress); }},
                               5);
    printComparison({"lists of labels", "mask field of all labels", "of half of them", "one label more"},
                    times);
  }
}

const Registration registration("labels", "105 labels of 512^3: lists, mask fields, a change of the set",
                                run);

}  // namespace
}  // namespace isolux::bench
