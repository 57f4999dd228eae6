// What hiding and showing pieces by hand makes of a scene's choice.
#include "app/view_math/piece_choice.h"

#include <gtest/gtest.h>

#include "tests/support/hidden_balls.h"
#include "volume/pieces/piece_sets.h"
#include "volume/pieces/shown_pieces.h"

namespace isolux::app {
namespace {

class PieceChoiceTest : public ::testing::Test {
 protected:
  std::shared_ptr<const volume::PreparedVolume> volume_ =
      test::prepared(test::gridOfBalls(test::pieceBalls(), true));
  base::Progress progress_;
  std::shared_ptr<const volume::Pieces> pieces_ = volume_->pieces->at(0.0, scene::Inside::above, progress_);

  // By balls.
  std::vector<bool> shown(const scene::Pieces& choice) const {
    const std::vector<bool> all = volume::shownPieces(*pieces_, choice);
    std::vector<bool> result;
    for (const test::PieceBall& ball : test::pieceBalls())
      result.push_back(all[pieces_->ofPoint(ball.middle)]);
    return result;
  }
  // From a point of the ball's surface.
  glm::dvec3 seedOf(std::size_t ball) const {
    const test::PieceBall of = test::pieceBalls()[ball];
    const glm::dvec3 at = of.middle + of.radius * glm::normalize(glm::dvec3(1.0, -2.0, 0.5));
    const auto seed = seedOfPick(*volume_, {at, at, 0.0, 0.0}, scene::Inside::above);
    EXPECT_TRUE(seed);
    return seed.value_or(glm::dvec3(0.0));
  }
};

TEST_F(PieceChoiceTest, ThePointOfAPickLiesDeepInItsPiece) {
  for (std::size_t i = 0; i < test::pieceBalls().size(); ++i) {
    const test::PieceBall ball = test::pieceBalls()[i];
    // Values are cut 2 voxels below the surface.
    EXPECT_LT(glm::length(seedOf(i) - ball.middle), ball.radius - 1.0) << i;
  }
}

TEST_F(PieceChoiceTest, HidingShowingAndIsolating) {
  scene::Pieces choice = withHidden({}, {seedOf(0)});
  choice = withHidden(choice, {seedOf(3)});
  EXPECT_EQ(shown(choice), (std::vector<bool>{false, true, true, false, true}));
  const auto id = pieces_->ofPoint(test::pieceBalls()[0].middle);
  // By whatever point it was named.
  EXPECT_EQ(withShown(choice, *pieces_, id, test::pieceBalls()[0].middle), withHidden({}, {seedOf(3)}));
  EXPECT_EQ(shown(onlyThese({seedOf(1), seedOf(2)})), (std::vector<bool>{false, true, true, false, false}));
  EXPECT_EQ(shown(withShown(onlyThese({seedOf(1)}), *pieces_, id, seedOf(0))),
            (std::vector<bool>{true, true, false, false, false}));
  EXPECT_EQ(withShown(onlyThese({seedOf(0)}), *pieces_, id, seedOf(0)), onlyThese({seedOf(0)}));
  EXPECT_EQ(shown(onlyLargest(1)), (std::vector<bool>{false, false, true, false, false}));
}

}  // namespace
}  // namespace isolux::app
