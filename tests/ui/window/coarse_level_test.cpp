// A volume that does not fit into memory: an overview, which says that it is one.
#include <algorithm>
#include <fstream>
#include <string>

#include <QLabel>
#include <QSpinBox>

#include <glm/geometric.hpp>

#include "tests/support/memory_limit.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/panels/volume_panel.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::test {
namespace {

// A ball of radius 0.4 n, 8 bits.
QString writeLargeBall(const QString& name, int n) {
  std::ofstream file(name.toStdString(), std::ios::binary);
  const std::string size = std::to_string(n);
  file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 3\nsizes: " << size << ' ' << size << ' ' << size
       << "\n\n";
  std::string slice(static_cast<std::size_t>(n * n), '\0');
  for (int z = 0; z < n; ++z) {
    for (int i = 0; i < n * n; ++i) {
      const double distance = glm::length(glm::dvec3(i % n, i / n, z) - 0.5 * (n - 1));
      slice[static_cast<std::size_t>(i)] =
          static_cast<char>(std::clamp(128.0 + 4.0 * (0.4 * n - distance), 0.0, 255.0));
    }
    file << slice;
  }
  return name;
}

TEST_F(WindowTest, AVolumeThatDoesNotFitIsShownAsAnOverviewThatSaysSo) {
  constexpr int kLarge = 320;
  const QString file = writeLargeBall(newFile("large.nrrd"), kLarge);
  ui::Document* const document = window_->document();
  ui::VolumePanel* const panel = window_->panel<ui::VolumePanel>();
  {
    const MemoryLimit limit(std::size_t{44} << 20);  // 320^3 voxels want 47 MiB, 160^3 6 MiB
    ASSERT_TRUE(load(*window_, file));
    EXPECT_EQ(document->scene().source.level, 1);
    EXPECT_EQ(document->volume()->grid().dims(), glm::ivec3(kLarge / 2));
    EXPECT_FALSE(document->modified());
    EXPECT_EQ(window_->coarseLabel()->text(), "Overview: level 1");
    EXPECT_TRUE(window_->coarseLabel()->toolTip().contains("thinner than"));
    EXPECT_TRUE(panel->warnings().contains("level 1"));
    EXPECT_TRUE(panel->levelChoice()->isVisibleTo(panel));
    EXPECT_EQ(panel->levelChoice()->maximum(), 5);
  }
  panel->levelChoice()->setValue(2);
  ASSERT_TRUE(waitUntil([&] { return !document->loading() && document->scene().source.level == 2; }));
  EXPECT_EQ(document->volume()->grid().dims(), glm::ivec3(kLarge / 4));
  document->undo();
  ASSERT_TRUE(waitUntil([&] { return !document->loading() && document->scene().source.level == 1; }));
  panel->levelChoice()->setValue(0);  // there is memory for it now
  ASSERT_TRUE(waitUntil([&] { return !document->loading() && document->scene().source.level == 0; }));
  EXPECT_EQ(document->volume()->grid().dims(), glm::ivec3(kLarge));
  EXPECT_EQ(window_->coarseLabel()->text(), "");
  document->undo();  // the label is that of what is shown
  EXPECT_EQ(window_->coarseLabel()->text(), "");
  ASSERT_TRUE(waitUntil([&] { return !document->loading() && document->scene().source.level == 1; }));
  EXPECT_EQ(window_->coarseLabel()->text(), "Overview: level 1");
}

}  // namespace
}  // namespace isolux::test
