#include "app/tasks/step_player.h"

#include <cmath>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>

#include "base/memory_budget.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

constexpr int kVoxels = 32 * 32 * 32;

// Three steps; the voxels of step n are 10 n.
class StepPlayerTest : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path path = test::temporaryFolder() / "steps.nrrd";
    std::ofstream file(path, std::ios::binary);
    file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 4\nsizes: 32 32 32 3\n"
            "kinds: domain domain domain list\n\n";
    for (int i = 0; i < 3 * kVoxels; ++i) file.put(static_cast<char>(10 * (i / kVoxels)));
    file.close();
    shown_.source.path = path.string();
    base::Progress progress;
    shown_.volume = volume::loadVolume(shown_.source, progress);
  }

  // The step that comes at this time, once it is loaded.
  static double stepAt(StepPlayer& player, double seconds) {
    std::optional<StepPlayer::Step> step;
    EXPECT_TRUE(test::pollUntil([&] { return (step = player.at(seconds)) || player.error(); }));
    if (!step) return -1.0;
    EXPECT_NEAR(step->volume->grid().value(0, 0, 0), 10.0 * step->source.timeStep, 1e-5);
    return step->source.timeStep;
  }

  StepPlayer::Step shown_;
};

TEST_F(StepPlayerTest, FastItShowsTheStepsAndStartsAgain) {
  ASSERT_EQ(StepPlayer::blendsOf(10.0), 1);
  StepPlayer player(shown_, 10.0);
  EXPECT_FALSE(player.at(0.0)) << "it is on show";
  for (const int n : {1, 2, 3, 4, 5, 6}) EXPECT_EQ(stepAt(player, 0.1 * n + 0.05), n % 3);
}

TEST_F(StepPlayerTest, SlowItShowsBlendsBetweenThem) {
  ASSERT_EQ(StepPlayer::blendsOf(2.0), 4);
  ASSERT_EQ(StepPlayer::blendsOf(0.1), 8);
  StepPlayer player(shown_, 2.0);
  player.at(0.0);
  std::vector<double> shown;
  for (int frame = 1; frame <= 9; ++frame) shown.push_back(stepAt(player, 0.125 * frame + 0.06));
  EXPECT_EQ(shown, (std::vector<double>{0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 0}));
}

TEST_F(StepPlayerTest, StepsThatAreLateAreLeftOut) {
  StepPlayer player(shown_, 10.0);
  EXPECT_FALSE(player.at(0.05));  // the first step is being loaded
  EXPECT_EQ(stepAt(player, 0.45), 1) << "once, though its turn came twice, and step 2 was not there in time";
  EXPECT_FALSE(player.at(0.45));
}

TEST_F(StepPlayerTest, AStepThatCannotBeLoadedIsTold) {
  StepPlayer player(shown_, 10.0);
  std::filesystem::remove(shown_.source.path);
  EXPECT_TRUE(test::pollUntil([&] {
    player.at(0.05);
    return player.error().has_value();
  }));
}

TEST_F(StepPlayerTest, WithoutRoomStepsAreLoadedOneAtATime) {
  base::MemoryBudget& memory = base::machineMemory();
  const std::size_t limit = memory.limit();
  // For the step on show, the next one, and what reading it takes.
  memory.setLimit(memory.limit() - memory.left() + 4 * kVoxels);
  for (const double seconds : {0.01, 0.35}) {  // between two looks; a round of the steps takes 0.3 s
    StepPlayer player(shown_, 10.0);
    int looks = 0, shown = 0;
    EXPECT_TRUE(test::pollUntil([&] {
      if (player.at(seconds * ++looks)) ++shown;
      return shown == 5;
    })) << seconds;
    EXPECT_FALSE(player.error());
  }
  memory.setLimit(limit);
}

}  // namespace
}  // namespace isolux::app
