// A file of which a part cannot be read: it opens with a hole, says so as long as it is shown, and is saved
// so.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <QLabel>

#include <glm/geometric.hpp>

#include "tests/support/ui/window_fixture.h"
#include "tests/support/zarr_folder.h"
#include "ui/panels/volume_panel.h"
#include "ui/window/message_bar.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;

constexpr int kSize = 48, kChunk = 16;

// A ball of radius 0.4 n, with a chunk in front of its middle.
std::vector<std::uint8_t> ball() {
  std::vector<std::uint8_t> voxels;
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double distance = glm::length(glm::dvec3(x, y, z) - 0.5 * (kSize - 1));
        voxels.push_back(
            static_cast<std::uint8_t>(std::clamp(128.0 + 4.0 * (0.4 * kSize - distance), 0.0, 255.0)));
      }
  return voxels;
}

class DamagedFileTest : public WindowTest {
 protected:
  QString write(const QString& name, bool whole) {
    const QString folder = newFile(name);
    writeZarr(folder.toStdString(), glm::ivec3(kSize), glm::ivec3(kChunk), ball());
    if (!whole) cutChunk(folder.toStdString(), glm::ivec3(1, 0, 1));
    return folder;
  }
  // Three time steps of the ball, a chunk of the last cut.
  QString writeSteps(const QString& name) {
    const fs::path folder = newFile(name).toStdString(), step = newFile(name + "_step").toStdString();
    fs::create_directories(folder);
    std::ofstream(folder / ".zarray")
        << R"({"zarr_format": 2, "shape": [3, 48, 48, 48], "chunks": [1, 16, 16, 16],
      "dtype": "|u1", "compressor": null, "fill_value": 0, "order": "C", "filters": null})";
    for (const char* t : {"0.", "1.", "2."}) {
      writeZarr(step, glm::ivec3(kSize), glm::ivec3(kChunk), ball());
      if (*t == '2') cutChunk(step, glm::ivec3(1, 0, 1));
      for (const fs::directory_entry& chunk : fs::directory_iterator(step))
        if (chunk.path().filename() != ".zarray")
          fs::rename(chunk.path(), folder / (t + chunk.path().filename().string()));
    }
    return QString::fromStdString(folder.string());
  }
  ui::Document* document() { return window_->document(); }
  QString said() { return window_->coarseLabel()->text(); }
};

TEST_F(DamagedFileTest, OpensWithAHoleAndSaysSo) {
  ASSERT_TRUE(load(*window_, write("cut.zarr", false)));
  EXPECT_TRUE(document()->scene().source.aroundDamage);
  EXPECT_FALSE(document()->modified());
  EXPECT_EQ(document()->volume()->grid().missingCount(), std::size_t{kChunk * kChunk * kChunk});
  EXPECT_EQ(said(), "Parts missing");
  EXPECT_TRUE(window_->coarseLabel()->toolTip().contains("1.0.1"));
  EXPECT_TRUE(window_->messageBar()->text().contains("a part of it cannot be read"));
  EXPECT_TRUE(window_->panel<ui::VolumePanel>()->warnings().contains("count as missing"));
  fullPicture(*window_);
  // The session is of the hole; what is opened next is whole.
  const QString session = newFile("cut.json");
  ASSERT_TRUE(document()->saveSession(session));
  ASSERT_TRUE(load(*window_, write("whole.zarr", true)));
  EXPECT_FALSE(document()->scene().source.aroundDamage);
  EXPECT_EQ(said(), "");
  EXPECT_EQ(window_->coarseLabel()->toolTip(), "");
  ASSERT_TRUE(load(*window_, session));
  EXPECT_EQ(said(), "Parts missing");
  EXPECT_FALSE(document()->modified());
}

TEST_F(DamagedFileTest, ATimeStepWithAHoleIsShownLikeTheOthers) {
  ASSERT_TRUE(load(*window_, writeSteps("steps.zarr")));
  EXPECT_FALSE(document()->scene().source.aroundDamage);
  EXPECT_EQ(said(), "");
  const scene::Scene before = document()->resolvedScene();
  const auto goTo = [&](int step) {
    ui::Edit edit{document()->scene(), "step", {}, false};
    edit.scene.source.timeStep = step;
    document()->edit(edit);
    return waitUntil([&] { return !document()->loading() && document()->scene().source.timeStep == step; });
  };
  ASSERT_TRUE(goTo(1));
  EXPECT_EQ(said(), "");
  ASSERT_TRUE(goTo(2));  // loaded ahead
  EXPECT_TRUE(document()->scene().source.aroundDamage);
  EXPECT_EQ(said(), "Parts missing");
  EXPECT_EQ(document()->resolvedScene().camera, before.camera);
  EXPECT_EQ(document()->resolvedScene().surfaces.front().value, before.surfaces.front().value);
  document()->undo();
  ASSERT_TRUE(waitUntil([&] { return !document()->loading() && document()->scene().source.timeStep == 1; }));
  EXPECT_EQ(said(), "");
  EXPECT_FALSE(document()->scene().source.aroundDamage);
}

}  // namespace
}  // namespace isolux::test
