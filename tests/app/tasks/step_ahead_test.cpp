#include "app/tasks/step_ahead.h"

#include <array>
#include <fstream>

#include <gtest/gtest.h>

#include "base/memory_budget.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

// Four steps of 8 voxels each; those of step n are 10 n.
class StepAheadTest : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path path = test::temporaryFolder() / "steps.nrrd";
    std::ofstream file(path, std::ios::binary);
    file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 4\nsizes: 2 2 2 4\n"
            "kinds: domain domain domain list\n\n";
    for (int i = 0; i < 32; ++i) file.put(static_cast<char>(10 * (i / 8)));
    file.close();
    source_.path = path.string();
    base::Progress progress;
    shown_ = volume::loadVolume(source_, progress);
    ASSERT_EQ(shown_->volume.timeSteps, 4);
  }
  scene::Source step(int n) const {
    scene::Source source = source_;
    source.timeStep = n;
    return source;
  }

  scene::Source source_;
  std::shared_ptr<const volume::PreparedVolume> shown_;
  StepAhead ahead_;
};

TEST_F(StepAheadTest, TheNextStepIsLoadedInTheDirectionOfTheLast) {
  for (const auto& [from, to, next] : {std::array{0, 1, 2}, std::array{3, 2, 1}, std::array{0, 2, 3}}) {
    ahead_.moved(step(from), step(to), *shown_);
    const std::unique_ptr<LoadTask> task = ahead_.take(step(next));
    ASSERT_TRUE(task) << from << " to " << to;
    ASSERT_TRUE(test::pollUntil([&] { return task->finished(); }));
    ASSERT_FALSE(task->error());
    EXPECT_EQ(task->value().volume->grid().value(0, 0, 0), 10.0 * next);
    EXPECT_FALSE(ahead_.take(step(next))) << "taken once";
  }
}

TEST_F(StepAheadTest, NothingIsLoadedThatNobodyIsExpectedToWant) {
  ahead_.moved(step(2), step(3), *shown_);  // the last
  EXPECT_FALSE(ahead_.take(step(4)));
  ahead_.moved(step(1), step(0), *shown_);
  EXPECT_FALSE(ahead_.take(step(-1)));
  ahead_.moved(step(1), step(1), *shown_);
  EXPECT_FALSE(ahead_.take(step(2)));
  scene::Source other = step(1);
  other.component = 1;
  ahead_.moved(step(0), other, *shown_);
  other.timeStep = 2;
  EXPECT_FALSE(ahead_.take(other));
}

TEST_F(StepAheadTest, AnotherWishStopsIt) {
  ahead_.moved(step(0), step(1), *shown_);
  EXPECT_FALSE(ahead_.take(step(3)));
  EXPECT_FALSE(ahead_.take(step(2))) << "given up";
}

TEST_F(StepAheadTest, ItNeedsRoomForTwo) {
  base::MemoryBudget& memory = base::machineMemory();
  const std::size_t limit = memory.limit();
  memory.setLimit(memory.limit() - memory.left() + 16);
  ahead_.moved(step(0), step(1), *shown_);
  const bool began = ahead_.take(step(2)) != nullptr;
  memory.setLimit(limit);
  EXPECT_FALSE(began);
}

}  // namespace
}  // namespace isolux::app
