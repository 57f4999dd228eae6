// Light of tiles as bytes: every bit arrives, and what is not whole is refused.
#include "app/cluster/tile_bytes.h"

#include <bit>
#include <random>

#include <gtest/gtest.h>

#include "app/cluster/cluster_messages.h"
#include "app/cluster/tile_requests.h"
#include "base/error.h"
#include "gi/lattice/lattice_part.h"

namespace isolux::app {
namespace {

// Any numbers, in three of four blocks.
void fill(gi::LightLattice& lattice, unsigned seed) {
  const gi::LatticeGeometry& geometry = lattice.geometry();
  const gi::LightContent& content = lattice.content();
  std::mt19937 random(seed);
  for (std::uint32_t b = 0; b < geometry.blockCount(); ++b) {
    if (random() % 4 == 0) continue;
    gi::LatticeBlock block = lattice.dark();
    for (std::size_t i = 0; i < gi::kTexelsOfBlock; ++i) {
      block.unlit[i] = random() % 3 == 0;
      if (block.unlit[i]) continue;
      block.normals[i] = {0.6f, 0.0f, -0.8f};
      block.samples[i] = static_cast<std::uint32_t>(random() % 3);
      if (!block.places.empty()) block.places[i] = glm::vec3(static_cast<float>(random() % 9));
    }
    for (float& mean : block.means)
      mean = std::bit_cast<float>(static_cast<std::uint32_t>(random()) & 0x7effffffu);
    for (std::size_t i = 0; i < gi::kTexelsOfBlock; ++i)
      if (block.unlit[i])
        for (int c = 0; c < content.components(); ++c)
          block.means[i * static_cast<std::size_t>(content.components()) + static_cast<std::size_t>(c)] =
              0.0f;
    lattice.write(b, std::move(block));
  }
}

void expectSame(const gi::LightLattice& a, const gi::LightLattice& b) {
  for (std::uint32_t i = 0; i < a.geometry().blockCount(); ++i) {
    const auto one = a.at(i), other = b.at(i);
    ASSERT_EQ(one == nullptr, other == nullptr) << i;
    if (!one) continue;
    EXPECT_EQ(one->samples, other->samples);
    EXPECT_EQ(one->normals, other->normals);
    EXPECT_EQ(one->places, other->places);
    EXPECT_EQ(one->unlit, other->unlit);
    EXPECT_EQ(one->means, other->means);
  }
}

TEST(TileBytes, EveryBitOfATileArrives) {
  for (const bool ofOne : {false, true})
    for (const gi::LightContent content : {gi::LightContent{gi::LightContent::Kind::irradiance, 1, 0},
                                           gi::LightContent{gi::LightContent::Kind::transfer, 3, 2}}) {
      const auto geometry =
          gi::LatticeGeometry::make({41, 33, 20}, 1.0, ofOne ? std::optional<float>(0.5f) : std::nullopt);
      gi::LightLattice from(geometry, content, "key");
      fill(from, 7);
      gi::LightLattice into(geometry, content, "key");
      std::vector<gi::BlockRequest> all;
      for (std::uint32_t b = 0; b < geometry.blockCount(); ++b)
        all.push_back({b, std::bitset<gi::kTexelsOfBlock>().set()});
      const TileRequests requests = tileRequests(geometry, all, {});
      EXPECT_EQ(requests.of.size(), gi::tilesOf(geometry).count);
      std::size_t blocks = 0;
      for (const TileRequest& request : requests.of) {
        blocks += request.sky.size();
        const std::string bytes = tileBytes(from, request.sky);
        takeTileBytes(bytes, request.sky, into);
        EXPECT_TRUE(tileBytes(into, request.sky) == bytes);
        EXPECT_EQ(pathsOf(into, request.sky), pathsOf(from, request.sky));
      }
      EXPECT_EQ(blocks, all.size());
      expectSame(from, into);
    }
}

TEST(TileBytes, WhatIsCutOffOrOfAnotherTileIsRefused) {
  const auto geometry = gi::LatticeGeometry::make({40, 40, 40}, 1.0);
  const gi::LightContent content{gi::LightContent::Kind::irradiance, 3, 0};
  gi::LightLattice from(geometry, content, "key");
  fill(from, 3);
  const std::vector<gi::BlockRequest> tile{{1, {}}, {2, {}}, {5, {}}}, other{{7, {}}};
  const std::string bytes = tileBytes(from, tile);
  ASSERT_GT(bytes.size(), 200u);
  gi::LightLattice into(geometry, content, "key");
  EXPECT_THROW(takeTileBytes(bytes, other, into), base::Error);
  for (std::size_t cut = 1; cut < bytes.size(); cut += 97)
    EXPECT_THROW(takeTileBytes(std::string_view(bytes).substr(0, bytes.size() - cut), tile, into),
                 base::Error)
        << cut;
  EXPECT_EQ(into.bakedTexels(), 0u);
}

TEST(SharedBlocks, AreTheSameInBothLatticesAndGoWhenTakenOut) {
  const auto geometry = gi::LatticeGeometry::make({16, 16, 16}, 1.0);
  const gi::LightContent content{gi::LightContent::Kind::irradiance, 3, 0};
  gi::LightLattice from(geometry, content, "key");
  fill(from, 5);
  gi::LightLattice into(geometry, content, "key");
  for (std::uint32_t b = 0; b < geometry.blockCount(); ++b)
    if (from.at(b)) into.share(b, from.at(b));
  expectSame(from, into);
  EXPECT_EQ(into.bakedTexels(), from.bakedTexels());
  for (std::uint32_t b = 0; b < geometry.blockCount(); ++b) into.share(b, nullptr);
  EXPECT_EQ(into.bakedTexels(), 0u);
  EXPECT_TRUE(into.changedSince(0).empty());
  EXPECT_EQ(into.bytesToFill(), gi::LightLattice(geometry, content, "").bytesToFill());
}

TEST(ClusterMessages, ArriveAsTheyWereSentOrAreRefused) {
  ClusterSetup setup;
  setup.version = "1";
  setup.path = "a b.vti";
  setup.scene = "{}";
  setup.seen.outer = {{1.0f, 2.0f, 3.0f}, {4.0f, 5.0f, 6.0f}};
  setup.sendsVolume = true;
  setup.probeWidth = 4;
  const std::string bytes = bytesOf(setup);
  const ClusterSetup read = messageFrom<ClusterSetup>(bytes);
  EXPECT_EQ(read.path, setup.path);
  EXPECT_EQ(read.seen.outer, setup.seen.outer);
  EXPECT_TRUE(read.sendsVolume && !read.failed && !read.resumes);
  EXPECT_EQ(read.probeWidth, 4);
  for (std::size_t cut = 1; cut < bytes.size(); ++cut)
    EXPECT_THROW(messageFrom<ClusterSetup>(std::string_view(bytes).substr(0, bytes.size() - cut)),
                 base::Error);
  EXPECT_THROW(messageFrom<ClusterSetup>(bytes + "x"), base::Error);
  const base::Error error = errorFrom(bytesOf(base::Error(base::ErrorKind::memory, "f", "p", "r")));
  EXPECT_EQ(error.kind(), base::ErrorKind::memory);
  EXPECT_EQ(error.file() + error.place() + error.reason(), "fpr");
}

}  // namespace
}  // namespace isolux::app
