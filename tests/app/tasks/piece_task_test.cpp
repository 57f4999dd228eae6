// Pieces on a background thread: found, measured where asked for, left where nobody wants them any more.
#include "app/tasks/piece_task.h"

#include <gtest/gtest.h>

#include "tests/support/hidden_balls.h"
#include "tests/support/poll.h"
#include "volume/pieces/piece_sets.h"

namespace isolux::app {
namespace {

scene::Scene sceneOfBalls() {
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.derivatives.noise = 0.0;
  return scene;
}

TEST(PieceJob, FindsAndMeasures) {
  const auto volume = test::prepared(test::gridOfBalls(test::pieceBalls(), true));
  for (const bool measured : {false, true}) {
    const auto task = pieceTask({volume, 0.0, scene::Inside::above}, sceneOfBalls(), measured);
    ASSERT_TRUE(test::pollUntil([&] { return task->finished(); }));
    ASSERT_FALSE(task->error());
    const FoundPieces& found = task->value();
    EXPECT_EQ(found.pieces, volume->pieces->find(0.0, scene::Inside::above));
    ASSERT_EQ(found.measures.size(), measured ? test::pieceBalls().size() : 0u);
    for (std::size_t id = 0; id < found.measures.size(); ++id) {
      EXPECT_NEAR(found.measures[id].surface.volumeMm3.value, found.pieces->list()[id].volumeMm3,
                  0.01 * found.pieces->list()[id].volumeMm3);
      EXPECT_EQ(found.pieces->ofPoint(found.seedsMm.at(id)), id);
    }
  }
}

TEST(PieceJob, ThrownAwayItEndsElsewhere) {
  const auto volume = test::prepared(test::gridOfBalls(test::pieceBalls(), true));
  pieceTask({volume, 0.5, scene::Inside::above}, sceneOfBalls(), true);
  EXPECT_TRUE(base::awaitDestroyed(10.0));
}

}  // namespace
}  // namespace isolux::app
