#include "gi/texels/texel_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gi/texels/texel_band.h"

namespace isolux::gi {
namespace {

using Texels = std::set<std::tuple<int, int, int>>;
using testing::ElementsAre;
using testing::IsEmpty;

Texels texelsIn(const LatticeGeometry& lattice, const std::vector<BlockRequest>& wanted) {
  Texels texels;
  std::set<std::uint32_t> blocks;
  for (const BlockRequest& w : wanted) {
    EXPECT_TRUE(blocks.insert(w.block).second) << "a block twice";
    EXPECT_TRUE(w.texels.any());
    for (int i = 0; i < kTexelsOfBlock; ++i) {
      if (!w.texels[static_cast<std::size_t>(i)]) continue;
      const glm::ivec3 t = lattice.texelOf(w.block, i);
      EXPECT_TRUE(lattice.contains(t));
      texels.emplace(t.x, t.y, t.z);
    }
  }
  return texels;
}

// By the definition of the lookup, texel by texel.
void addLookup(const LatticeGeometry& lattice, const glm::dvec3& voxel, int reach, Texels& texels) {
  const glm::dvec3 at = lattice.texelOf(voxel);
  std::array<std::vector<int>, 3> read;
  for (int a = 0; a < 3; ++a) {
    const int base = std::clamp(static_cast<int>(std::floor(at[a])), 0, std::max(lattice.dims[a] - 2, 0));
    for (int t = base - reach + 1; t <= base + reach; ++t)
      if (t >= 0 && t < lattice.dims[a]) read[static_cast<std::size_t>(a)].push_back(t);
  }
  for (const int z : read[2])
    for (const int y : read[1])
      for (const int x : read[0]) texels.emplace(x, y, z);
}

TEST(TexelSets, AroundHitsIsWhatLookupsRead) {
  std::mt19937 random(3);
  for (const double scale : {0.1, 0.5, 1.0, 2.3})
    for (const int reach : {1, 2}) {
      const glm::ivec3 voxels(30, 9, 2);
      const LatticeGeometry lattice = LatticeGeometry::make(voxels, scale);
      std::vector<glm::vec3> hits{glm::vec3(0.0f), glm::vec3(voxels - 1), glm::vec3(NAN),
                                  glm::vec3(INFINITY, 1.0f, 0.0f)};
      Texels expected;
      for (int i = 0; i < 40; ++i) {
        const auto part = [&] { return static_cast<float>(random() % 9973) / 9973.0f; };
        hits.push_back(glm::vec3(part(), part(), part()) * glm::vec3(voxels - 1));
      }
      for (const glm::vec3& hit : hits)
        if (std::isfinite(hit.x)) addLookup(lattice, glm::dvec3(hit), reach, expected);
      EXPECT_EQ(texelsIn(lattice, texelsAround(lattice, hits, reach)), expected) << scale << " " << reach;
    }
}

TEST(TexelSets, AroundNothingIsNothing) {
  const LatticeGeometry lattice = LatticeGeometry::make({30, 9, 5}, 1.0);
  EXPECT_THAT(texelsAround(lattice, {}, 1), IsEmpty());
  const glm::vec3 missed(NAN);
  EXPECT_THAT(texelsAround(lattice, {&missed, 1}, 1), IsEmpty());
}

TEST(TexelSets, BlocksComeInTheOrderOfTheHits) {
  const LatticeGeometry lattice = LatticeGeometry::make({33, 9, 5}, 1.0);
  const std::vector<glm::vec3> hits{
      {25.0f, 1.0f, 1.0f}, {7.5f, 1.0f, 1.0f}, {26.0f, 1.0f, 1.0f}, {20.0f, 1.0f, 1.0f}};
  std::vector<std::uint32_t> order;
  for (const BlockRequest& w : texelsAround(lattice, hits, 1)) order.push_back(w.block);
  EXPECT_THAT(order, ElementsAre(3u, 0u, 1u, 2u));
}

TEST(TexelSets, BesideIsTheRestOfTheNeighbourhood) {
  const LatticeGeometry lattice = LatticeGeometry::make({27, 20, 9}, 1.0);
  std::mt19937 random(4);
  for (const int steps : {0, 1, 2, 7, 8, 11}) {
    std::vector<glm::vec3> hits;
    for (int i = 0; i < 6; ++i) hits.emplace_back(glm::vec3(random() % 27, random() % 20, random() % 9));
    const std::vector<BlockRequest> inner = texelsAround(lattice, hits, 1);
    const Texels own = texelsIn(lattice, inner);
    Texels expected;
    for (int z = 0; z < 9; ++z)
      for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 27; ++x)
          for (const auto& [ox, oy, oz] : own)
            if (std::max({std::abs(x - ox), std::abs(y - oy), std::abs(z - oz)}) <= steps)
              expected.emplace(x, y, z);
    for (const auto& texel : own) expected.erase(texel);
    EXPECT_EQ(texelsIn(lattice, texelsBeside(lattice, inner, steps)), expected) << steps;
  }
}

TEST(TexelSets, AllTexelsAreTheLattice) {
  const LatticeGeometry lattice = LatticeGeometry::make({17, 8, 3}, 1.0);
  EXPECT_EQ(texelsIn(lattice, allTexels(lattice)).size(), 17u * 8u * 3u);
}

// Points on the isosurfaces of a band, found along lines through the voxels, read only texels of the set;
// and the set has none that no voxel near it calls for.
TEST(TexelSets, BandHoldsAllThatItsIsosurfacesRead) {
  const glm::ivec3 dims(22, 19, 13);
  std::vector<float> values;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        values.push_back(x == 5 && y == 5 ? NAN
                                          : std::sin(0.5f * static_cast<float>(x)) +
                                                std::cos(0.4f * static_cast<float>(y + z)));
  const volume::Grid grid(volume::GridGeometry::make(dims, {1.0, 1.0, 1.0}), values, -2.0, 10.0);
  const double low = 9.0, high = 9.2;
  base::Progress progress;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (const double scale : {0.5, 1.0, 1.7})
    for (const int reach : {1, 2}) {
      const LatticeGeometry lattice = LatticeGeometry::make(dims, scale);
      const auto wanted = texelsOfBand(lattice, grid, low, high, reach, progress);
      const Texels found = texelsIn(lattice, wanted);
      Texels read;
      int points = 0;
      for (int i = 0; i < 200000; ++i) {
        const glm::dvec3 at = glm::dvec3(part(random), part(random), part(random)) * glm::dvec3(dims - 1);
        const glm::ivec3 cell = glm::min(glm::ivec3(at), dims - 2);
        const glm::dvec3 f = at - glm::dvec3(cell);
        double value = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
          const glm::ivec3 o(corner & 1, corner >> 1 & 1, corner >> 2);
          const glm::dvec3 w = glm::dvec3(o) * f + glm::dvec3(1 - o) * (1.0 - f);
          value += w.x * w.y * w.z * grid.value(cell.x + o.x, cell.y + o.y, cell.z + o.z);
        }
        if (!(value >= low && value <= high)) continue;
        ++points;
        addLookup(lattice, at, reach, read);
      }
      EXPECT_GT(points, 1000);
      for (const auto& texel : read) EXPECT_TRUE(found.contains(texel));

      // Exactly those whose surrounding voxels reach into the band.
      std::size_t expected = 0;
      for (int z = 0; z < lattice.dims.z; ++z)
        for (int y = 0; y < lattice.dims.y; ++y)
          for (int x = 0; x < lattice.dims.x; ++x) {
            const glm::ivec3 texel(x, y, z);
            glm::ivec3 first, last;
            for (int a = 0; a < 3; ++a) {
              const double step = lattice.voxelsPerTexel()[a];
              first[a] = std::max(static_cast<int>(std::floor((texel[a] - reach) * step + 1e-9)), 0);
              last[a] = std::min(static_cast<int>(std::ceil((texel[a] + reach) * step - 1e-9)), dims[a] - 1);
            }
            double least = INFINITY, most = -INFINITY;
            for (int vz = first.z; vz <= last.z; ++vz)
              for (int vy = first.y; vy <= last.y; ++vy)
                for (int vx = first.x; vx <= last.x; ++vx) {
                  const double v = grid.value(vx, vy, vz);
                  if (std::isnan(v)) continue;
                  least = std::min(least, v);
                  most = std::max(most, v);
                }
            const bool meets = least <= high && most >= low;
            expected += meets;
            EXPECT_EQ(found.contains({x, y, z}), meets) << x << " " << y << " " << z;
          }
      EXPECT_EQ(found.size(), expected);
    }
}

TEST(TexelSets, BandOfACubicFieldReachesFurther) {
  const volume::Grid grid = volume::Grid(volume::GridGeometry::make({20, 20, 20}, {1.0, 1.0, 1.0}), [] {
    std::vector<std::uint8_t> voxels(8000);
    voxels[10 + 20 * (10 + 20 * 10)] = 200;  // one bright voxel
    return voxels;
  }());
  const LatticeGeometry lattice = LatticeGeometry::make({20, 20, 20}, 1.0);
  base::Progress progress;
  const auto count = [&](scene::Field field) {
    return texelsIn(lattice, texelsOfBand(lattice, grid, 10.0, 20.0, 1, progress, field)).size();
  };
  EXPECT_EQ(count(scene::Field::trilinear), 27u);
  EXPECT_EQ(count(scene::Field::cubic), 125u);
}

TEST(TexelSets, BandCanBeStopped) {
  const volume::Grid grid(volume::GridGeometry::make({20, 20, 20}, {1.0, 1.0, 1.0}),
                          std::vector<std::uint8_t>(8000));
  base::Progress progress;
  progress.requestStop();
  EXPECT_THROW(texelsOfBand(LatticeGeometry::make({20, 20, 20}, 1.0), grid, 0.0, 1.0, 1, progress),
               base::Error);
}

}  // namespace
}  // namespace isolux::gi
