// A screen that is drawn at 200 %: run by CTest with QT_SCALE_FACTOR=2, and with it what the pointer does.
#include "tests/support/ui/window_fixture.h"

#include "scene/settings/settings.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

class FineScreenTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (window_->devicePixelRatioF() != 2.0) GTEST_SKIP() << "no fine screen: set QT_SCALE_FACTOR=2";
    ASSERT_TRUE(load(*window_, "phantom:ball:48"));
  }
  void set(const std::vector<std::string>& assignments) {
    ui::Edit edit{window_->document()->scene(), "Set", {}, false};
    for (const std::string& assignment : assignments) scene::applyAssignment(edit.scene, assignment);
    window_->document()->edit(edit);
  }
};

}  // namespace

TEST_F(FineScreenTest, EveryPixelOfTheScreenIsDrawn) {
  const QSize size = window_->viewport()->size();
  glm::ivec2 drawn(0);
  double ratio = 0.0;
  QObject::connect(window_->viewport(), &ui::Viewport::reported,
                   [&](const render::FrameReport&, const render::FrameRequest& request) {
                     drawn = request.size;
                     ratio = request.pixelRatio;
                   });
  set({"look.mode=lambert"});
  EXPECT_EQ(fullPicture(*window_).size(), 2 * size);
  EXPECT_EQ(drawn, glm::ivec2(2 * size.width(), 2 * size.height()));
  EXPECT_EQ(ratio, 2.0);
}

// As seen, not in pixels of the screen: the black rim of a bright ball before white.
TEST_F(FineScreenTest, LinesAreAsThickAsOnAnyScreen) {
  set({"look.mode=lambert", "look.ambient=1", "isosurface.albedo=0.5,0.5,0.5", "look.background_top=1,1,1",
       "look.background_bottom=1,1,1", "look.contours=1", "look.contour_width=6"});
  const QImage picture = fullPicture(*window_);
  const int row = picture.height() / 2;
  const auto isBlack = [&](int x) { return qGreen(picture.pixel(x, row)) < 90; };
  int x = 0;
  while (x < picture.width() && !isBlack(x)) ++x;
  const int begin = x;
  while (x < picture.width() && isBlack(x)) ++x;
  EXPECT_NEAR(x - begin, 2 * 6, 1.5);
}

}  // namespace isolux::test
