#include "volume/field/fill_missing.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "base/random.h"

namespace isolux::volume {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Values {
  glm::ivec3 dims;
  std::vector<float> v;
  std::size_t at(int x, int y, int z) const {
    return static_cast<std::size_t>((z * dims.y + y) * dims.x + x);
  }
};

// The definition: whole rings, each found by looking at every voxel.
std::vector<float> filledByDefinition(Values values) {
  for (int ring = 0; ring < kFilledRings; ++ring) {
    std::vector<float> next = values.v;
    for (int z = 0; z < values.dims.z; ++z)
      for (int y = 0; y < values.dims.y; ++y)
        for (int x = 0; x < values.dims.x; ++x) {
          if (!std::isnan(values.v[values.at(x, y, z)])) continue;
          double sum = 0.0;
          int count = 0;
          for (int k = std::max(z - 1, 0); k <= std::min(z + 1, values.dims.z - 1); ++k)
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, values.dims.y - 1); ++j)
              for (int i = std::max(x - 1, 0); i <= std::min(x + 1, values.dims.x - 1); ++i)
                if (const float v = values.v[values.at(i, j, k)]; !std::isnan(v))
                  sum += static_cast<double>(v), ++count;
          if (count > 0) next[values.at(x, y, z)] = static_cast<float>(sum / count);
        }
    values.v = std::move(next);
  }
  for (float& v : values.v)
    if (std::isnan(v)) v = 0.0f;
  return values.v;
}

Values randomValues(glm::ivec3 dims, double missing) {
  Values values{dims, {}};
  const auto count = static_cast<std::uint64_t>(dims.x) * static_cast<std::uint64_t>(dims.y * dims.z);
  for (std::uint64_t i = 0; i < count; ++i)
    values.v.push_back(base::uniformNoise(1, i) < missing ? kNan
                                                          : static_cast<float>(base::uniformNoise(2, i)));
  return values;
}

TEST(FillMissing, IsItsDefinitionForAnyGapsAndThreads) {
  for (const double missing : {0.02, 0.5, 0.97, 0.9995, 1.0})
    for (const glm::ivec3& dims : {glm::ivec3(23, 31, 19), glm::ivec3(1, 70, 9), glm::ivec3(64, 1, 1)}) {
      const Values values = randomValues(dims, missing);
      const std::vector<float> expected = filledByDefinition(values);
      base::Progress progress;
      std::vector<float> found = values.v;
      fillMissing(found, dims, progress, {});
      EXPECT_EQ(found, expected) << missing << ' ' << dims.x;
      std::vector<float> alone = values.v;
      tbb::task_arena(1).execute([&] { fillMissing(alone, dims, progress, {}); });
      EXPECT_EQ(alone, expected);
    }
}

TEST(FillMissing, BehindSixteenVoxelsStandsZero) {
  std::vector<float> values(60, kNan);
  values[0] = 5.0f;
  base::Progress progress;
  fillMissing(values, {60, 1, 1}, progress, {});
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], i <= kFilledRings ? 5.0f : 0.0f) << i;
}

}  // namespace
}  // namespace isolux::volume
