// Two windows beside each other: views that go together.
#include "tests/support/ui/window_fixture.h"

#include <QAction>

#include <glm/geometric.hpp>

#include "tests/support/test_data.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

scene::Camera cameraOf(const ui::MainWindow& window) {
  return window.document()->resolvedScene().camera;
}

// The direction of view, and how far away in parts of the volume's diagonal: what two phantoms have in
// common.
struct View {
  glm::dvec3 direction;
  double distance;
};
View viewOf(const ui::MainWindow& window) {
  const scene::Camera camera = cameraOf(window);
  const auto& facts = window.document()->volume()->facts;
  return {glm::normalize(*camera.target - *camera.eye),
          glm::length(*camera.target - *camera.eye) / glm::length(facts.boundsMaxMm - facts.boundsMinMm)};
}

}  // namespace

TEST_F(WindowTest, LinkedWindowsTurnTogetherAndAlone) {
  ASSERT_TRUE(load(*window_, "phantom:torus:24"));
  auto other = makeWindow();
  ASSERT_TRUE(load(*other, writeBall(32)));
  fullPicture(*window_);
  fullPicture(*other);
  const scene::Camera before = cameraOf(*other);
  drag(window_->viewport(), {300, 200}, {380, 240});
  EXPECT_EQ(cameraOf(*other), before) << "not linked";

  window_->linkAction()->trigger();
  EXPECT_TRUE(other->linkAction()->isChecked()) << "one check links all";
  EXPECT_NEAR(glm::length(viewOf(*other).direction - viewOf(*window_).direction), 0.0, 1e-9)
      << "the others show what this one shows";
  drag(window_->viewport(), {300, 200}, {380, 240});
  drag(window_->viewport(), {300, 200}, {300, 280}, Qt::RightButton);
  EXPECT_NEAR(glm::length(viewOf(*other).direction - viewOf(*window_).direction), 0.0, 1e-9);
  EXPECT_NEAR(viewOf(*other).distance, viewOf(*window_).distance, 1e-9);
  // The other way, too.
  const scene::Camera ours = cameraOf(*window_);
  drag(other->viewport(), {300, 200}, {250, 210});
  EXPECT_NE(cameraOf(*window_), ours);
  EXPECT_NEAR(glm::length(viewOf(*other).direction - viewOf(*window_).direction), 0.0, 1e-9);
  // What is opened in one does not turn the other.
  const scene::Camera kept = cameraOf(*window_);
  ASSERT_TRUE(load(*other, "phantom:ball:16"));
  fullPicture(*other);
  EXPECT_EQ(cameraOf(*window_), kept);
  other->linkAction()->trigger();
  const scene::Camera alone = cameraOf(*other);
  drag(window_->viewport(), {300, 200}, {350, 240});
  EXPECT_EQ(cameraOf(*other), alone);
}

TEST_F(WindowTest, AFollowedTurnIsOneStepOfUndo) {
  ASSERT_TRUE(load(*window_, "phantom:torus:24"));
  auto other = makeWindow();
  ASSERT_TRUE(load(*other, "phantom:ball:24"));
  fullPicture(*window_);
  fullPicture(*other);
  const scene::Camera before = other->document()->scene().camera;
  window_->linkAction()->trigger();
  drag(window_->viewport(), {300, 200}, {380, 240});
  ASSERT_TRUE(other->document()->history().canUndo());
  window_->linkAction()->trigger();  // so that undoing turns this one only
  other->document()->endGesture();
  other->document()->undo();
  EXPECT_EQ(other->document()->scene().camera, before);
  EXPECT_FALSE(other->document()->history().canUndo());
}

TEST_F(WindowTest, AViewIsUsedInTheOtherWindowOnce) {
  ASSERT_TRUE(load(*window_, "phantom:torus:24"));
  std::unique_ptr<ui::MainWindow> other(window_->newWindow());
  other->setAttribute(Qt::WA_DeleteOnClose, false);
  ASSERT_TRUE(load(*other, "phantom:ball:24"));
  fullPicture(*window_);
  fullPicture(*other);
  window_->viewport()->applyStandardView(scene::StandardView::left);
  EXPECT_GT(glm::length(viewOf(*other).direction - viewOf(*window_).direction), 0.1);
  window_->useViewElsewhere();
  EXPECT_NEAR(glm::length(viewOf(*other).direction - viewOf(*window_).direction), 0.0, 1e-9);
  window_->viewport()->applyStandardView(scene::StandardView::superior);
  EXPECT_GT(glm::length(viewOf(*other).direction - viewOf(*window_).direction), 0.1) << "once only";
}

}  // namespace isolux::test
