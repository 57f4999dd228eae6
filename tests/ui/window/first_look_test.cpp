// A first look at a volume that is being loaded: in the card, until it is there.
#include <QImage>
#include <QLabel>

#include "tests/support/ui/needles.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/window/load_card.h"

namespace isolux::test {
namespace {

class FirstLookTest : public WindowTest {
 protected:
  scene::Scene sceneOf(const QString& file) const {
    scene::Scene scene;
    scene.source.path = file.toStdString();
    return scene;
  }
};

TEST_F(FirstLookTest, TheCardShowsItUntilTheVolumeIsThere) {
  ui::LoadCard card(window_.get());
  card.setLeastBytes(0);
  card.begin("needles");
  card.lookAt(sceneOf(writeNeedles(newFile("needles.nrrd"))));
  EXPECT_FALSE(card.showsPicture());
  ASSERT_TRUE(waitUntil([&] { return card.showsPicture(); }));
  auto* const label = card.findChild<QLabel*>("firstLook");
  const QImage picture = label->pixmap().toImage();
  ASSERT_GT(picture.width(), 100);
  int coloured = 0;  // what is no background, which is bluish
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor color = picture.pixelColor(x, y);
      coloured += color.red() > color.blue();
    }
  EXPECT_GT(coloured, picture.width() * picture.height() / 20);
  const int tall = card.height();
  card.end();
  EXPECT_FALSE(card.showsPicture());
  card.begin("another");
  EXPECT_LT(card.height(), tall - 100);
}

TEST_F(FirstLookTest, ThereIsNoneOfWhatIsSmallOrCannotBeRead) {
  ui::LoadCard card(window_.get());
  card.begin("needles");
  card.lookAt(sceneOf(writeNeedles(newFile("needles.nrrd"))));
  waitUntil([&] { return card.showsPicture(); }, 1500);
  EXPECT_FALSE(card.showsPicture());
  card.setLeastBytes(0);
  card.lookAt(sceneOf("/nowhere.nrrd"));
  waitUntil([&] { return card.showsPicture(); }, 1500);
  EXPECT_FALSE(card.showsPicture());
}

// A look that was begun for one volume is not shown for the next.
TEST_F(FirstLookTest, ALookIsOfWhatIsBeingLoaded) {
  ui::LoadCard card(window_.get());
  card.setLeastBytes(0);
  card.begin("needles");
  card.lookAt(sceneOf(writeNeedles(newFile("needles.nrrd"))));
  card.begin("another");
  waitUntil([&] { return card.showsPicture(); }, 1500);
  EXPECT_FALSE(card.showsPicture());
}

}  // namespace
}  // namespace isolux::test
