// The protocol of a bake over ranks, with ranks that are threads: what arrives is the bake of one, whoever
// falls silent; what would make other light is refused.
#include "app/cluster/cluster_bake.h"

#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/cluster/cluster_volume.h"
#include "app/cluster/rank_facts.h"
#include "scene/rules/automatic.h"
#include "scene/settings/settings.h"
#include "tests/app/cluster/thread_ranks.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using app::ClusterBake;
using app::ClusterMessage;
using app::ClusterOptions;
using app::ClusterResult;
using app::ClusterScene;
using testing::HasSubstr;

app::VolumePointer volumeNamed(const std::string& name) {
  base::Progress progress;
  scene::Source source;
  source.path = name;
  return volume::loadVolume(source, progress);
}

class ClusterBakeProtocol : public testing::Test {
 protected:
  ClusterBakeProtocol() : volume_(volumeNamed("phantom:gyroid:40")) {
    scene::Scene scene;
    scene.source.path = "phantom:gyroid:40";
    scene.look.mode = scene::LookMode::gi;
    scene.gi.extent = scene::GiExtent::full;
    scene.gi.samples = 4;
    scene_ = scene::resolve(scene, volume_->facts);
  }

  ClusterOptions options(const std::string& name) const {
    ClusterOptions options;
    options.out = folder_ / name;
    options.threads = 1;
    options.farewellSeconds = 0.2;
    return options;
  }
  ClusterResult run(const std::shared_ptr<RankHub>& hub, const std::string& name) const {
    ThreadRanks ranks(hub, 0);
    ClusterBake bake(ranks, options(name));
    base::Progress progress;
    return bake.run("volume", ClusterScene{scene_, volume_, nullptr}, progress);
  }
  std::thread worker(const std::shared_ptr<RankHub>& hub, int rank,
                     const std::string& volume = "phantom:gyroid:40") const {
    return std::thread([this, hub, rank, volume] {
      ThreadRanks ranks(hub, rank);
      base::Progress progress;
      const auto load = [&](const std::string&, const scene::Source&) { return volumeNamed(volume); };
      app::serveClusterBake(ranks, options("none"), load, progress);
    });
  }
  std::string bytesOf(const std::string& name) const { return contentOf(folder_ / name); }

  std::filesystem::path folder_ = temporaryFolder();
  app::VolumePointer volume_;
  scene::Scene scene_;
};

TEST_F(ClusterBakeProtocol, ThreeRanksMakeTheBakeOfOne) {
  run(std::make_shared<RankHub>(1), "one.vti");
  const auto hub = std::make_shared<RankHub>(3);
  std::thread first = worker(hub, 1), second = worker(hub, 2);
  const ClusterResult result = run(hub, "three.vti");
  first.join();
  second.join();
  EXPECT_TRUE(bytesOf("one.vti") == bytesOf("three.vti"));
  std::uint64_t tiles = 0;
  for (const app::RankReport& rank : result.ranks) {
    EXPECT_TRUE(rank.left);
    tiles += rank.work.tiles;
  }
  EXPECT_GE(tiles, 8u);
  EXPECT_GT(result.ranks[1].work.tiles + result.ranks[2].work.tiles, 0u);
  EXPECT_EQ(result.state.counters.texelsLit,
            run(std::make_shared<RankHub>(1), "one.vti").state.counters.texelsLit);
}

// It says hello, takes its tiles, and is not heard of again.
TEST_F(ClusterBakeProtocol, TheTilesOfARankThatFallsSilentAreBakedByOthers) {
  run(std::make_shared<RankHub>(1), "one.vti");
  const auto hub = std::make_shared<RankHub>(2);
  std::thread silent([&] {
    ThreadRanks ranks(hub, 1);
    base::Progress progress;
    ranks.send(0, static_cast<int>(ClusterMessage::here), "quiet-host");
    std::string setup;
    app::broadcastText(ranks, setup, progress);
    app::ClusterLight light(ClusterScene{scene_, volume_, nullptr}, 1, progress);
    app::ClusterHello hello = app::helloOf(light, volume_->grid(), 1, true);
    hello.host = "quiet-host";
    ranks.send(0, static_cast<int>(ClusterMessage::hello), app::bytesOf(hello));
  });
  const ClusterResult result = run(hub, "two.vti");
  silent.join();
  EXPECT_TRUE(bytesOf("one.vti") == bytesOf("two.vti"));
  EXPECT_FALSE(result.ranks[1].left);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_THAT(result.notes[0], HasSubstr("rank 1 on quiet-host does not answer"));
}

// Its second answers differ from those that counted, or it has another volume.
TEST_F(ClusterBakeProtocol, ARankThatWouldMakeOtherLightEndsTheBakeWithItsName) {
  const auto hub = std::make_shared<RankHub>(2);
  std::thread other = worker(hub, 1, "phantom:gyroid:41");
  ThreadRanks ranks(hub, 0);
  ClusterBake bake(ranks, options("two.vti"));
  base::Progress progress;
  try {
    bake.run("volume", ClusterScene{scene_, volume_, nullptr}, progress);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    EXPECT_THAT(error.what(), HasSubstr("rank 1 on "));
    EXPECT_THAT(error.what(), HasSubstr("has another volume"));
  }
  EXPECT_TRUE(bake.release());
  other.join();
  EXPECT_FALSE(std::filesystem::exists(folder_ / "two.vti"));
}

TEST_F(ClusterBakeProtocol, TwoAnswersThatDifferNameBothHosts) {
  const auto hub = std::make_shared<RankHub>(2);
  ThreadRanks ranks(hub, 0), liar(hub, 1);
  base::Progress progress;
  app::ClusterLight light(ClusterScene{scene_, volume_, nullptr}, 1, progress);
  app::ClusterHello hello = app::helloOf(light, volume_->grid(), 1, true);
  hello.host = "good-host";
  app::ClusterMaster master(ranks, light, hello, light.fresh(), {});
  hello.host = "bad-host";
  liar.send(0, static_cast<int>(ClusterMessage::hello), app::bytesOf(hello));
  while (!master.isFinished()) master.step();
  const std::uint32_t tile = light.requests().tiles().front();
  app::TileMessage wrong;
  wrong.tile = tile;
  liar.send(0, static_cast<int>(ClusterMessage::light), app::bytesOf(wrong));
  try {
    master.step();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const base::Error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("good-host"), HasSubstr("bad-host"),
                                             HasSubstr("tile " + std::to_string(tile))));
  }
}

TEST_F(ClusterBakeProtocol, AVolumeAndALightProbeThatAreSentAreTheSame) {
  const auto hub = std::make_shared<RankHub>(2);
  std::vector<glm::vec3> pixels{{1, 2, 3}, {0, 0, 0}, {4, 5, 6}, {7, 1, 1}};
  const auto probe = std::make_shared<gi::Environment>(2, 2, pixels);
  base::Progress progress;
  ThreadRanks sender(hub, 0), receiver(hub, 1);
  app::broadcastVolume(sender, volume_, progress);
  app::broadcastProbe(sender, probe, 2, 2, progress);
  const app::VolumePointer received = app::broadcastVolume(receiver, nullptr, progress);
  EXPECT_EQ(received->grid().hash(), volume_->grid().hash());
  EXPECT_EQ(received->volume.axes, volume_->volume.axes);
  const auto same = app::broadcastProbe(receiver, nullptr, 2, 2, progress);
  EXPECT_EQ(same->hash(), probe->hash());
}

TEST_F(ClusterBakeProtocol, AnErrorBeforeAnythingBeginsLetsTheOthersGo) {
  const auto hub = std::make_shared<RankHub>(2);
  std::thread other = worker(hub, 1);
  ThreadRanks ranks(hub, 0);
  ClusterBake bake(ranks, options("two.vti"));
  EXPECT_TRUE(bake.release());
  other.join();
}

}  // namespace
}  // namespace isolux::test
