// Which labels a surface has, and the fields that are made of them.
#include "volume/prepared/label_surfaces.h"

#include <gtest/gtest.h>

#include "tests/support/label_volumes.h"
#include "tests/support/surfaces.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::test {
namespace {

using Labels = std::vector<std::vector<int>>;

class LabelSurfacesTest : public ::testing::Test {
 protected:
  // Surfaces that name these labels.
  scene::Scene with(const std::vector<const char*>& labels) const {
    scene::Scene scene;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      scene::Surface& surface = surfaceAt(scene, i);
      surface.shown = true;
      surface.opacity = 1.0;
      surface.labels = labels[i];
    }
    return scene::resolve(scene, volume_->facts);
  }
  volume::LabelSurfaces::Fields fields(const scene::Scene& scene) {
    return volume::labelFields(*volume_, scene, progress_);
  }
  static std::vector<int> labelsOf(const std::shared_ptr<const volume::PreparedVolume>& field) {
    return field ? field->labels->mask.labels : std::vector<int>{};
  }

  base::Progress progress_;
  std::shared_ptr<const volume::PreparedVolume> volume_ = loadedLabels(threeLabels());
};

TEST_F(LabelSurfacesTest, ALabelIsOfTheFirstThatNamesItElseOfTheFirstThatNamesNone) {
  const auto of = [&](const std::vector<const char*>& labels) {
    return volume::labelsOfSurfaces(with(labels), *volume_->labels);
  };
  EXPECT_EQ(of({""}), (Labels{{1, 2, 3}}));
  EXPECT_EQ(of({"", "2"}), (Labels{{1, 3}, {2}}));
  EXPECT_EQ(of({"1-2", "2,3", ""}), (Labels{{1, 2}, {3}, {}}));
  EXPECT_EQ(of({"", "", "3"}), (Labels{{1, 2}, {}, {3}}));
  EXPECT_EQ(of({"2"}), (Labels{{2}}));
  const auto some = loadedLabels(threeLabels(), "1,3");
  EXPECT_EQ(volume::labelsOfSurfaces(with({"", "2,3"}), *some->labels), (Labels{{1}, {3}}))
      << "of those shown";
}

TEST_F(LabelSurfacesTest, AnUnknownLabelIsRefusedWithTheSurfacesPath) {
  scene::Scene scene = with({"", "2,liver"});
  scene.surfaces[1].id = "organ";
  try {
    fields(scene);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find("surfaces.organ.labels"), std::string::npos) << error.what();
  }
}

TEST_F(LabelSurfacesTest, OneSurfaceOfAllHasNoFieldOfItsOwn) {
  EXPECT_TRUE(fields(with({""})).empty());
  EXPECT_TRUE(fields(with({"1-3"})).empty());
  scene::Scene smoother = with({""});
  smoother.surfaces.front().smoothing = 2.0;
  ASSERT_EQ(fields(smoother).size(), 1u);
  EXPECT_EQ(fields(smoother).front()->labels->mask.smoothing, 2.0);
}

TEST_F(LabelSurfacesTest, FieldsAreThoseOfTheirLabelsAloneAndKept) {
  const scene::Scene scene = with({"", "2"});
  EXPECT_FALSE(volume_->labelSurfaces->find(scene, *volume_->labels));
  const auto made = fields(scene);
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(labelsOf(made[0]), (std::vector<int>{1, 3}));
  EXPECT_EQ(labelsOf(made[1]), (std::vector<int>{2}));
  EXPECT_EQ(made[1]->grid().hash(), loadedLabels(threeLabels(), "2")->grid().hash());
  EXPECT_EQ(fields(scene), made);
  // Hiding a label makes anew what it was in.
  scene::Source source;
  source.labels = "1,2";
  volume_ = volume::showOtherLabels(*volume_, source, progress_);
  const auto after = fields(scene);
  EXPECT_EQ(labelsOf(after[0]), (std::vector<int>{1}));
  EXPECT_EQ(after[1], made[1]);
  source.labels = "1,3";
  volume_ = volume::showOtherLabels(*volume_, source, progress_);
  EXPECT_EQ(fields(scene)[1], nullptr) << "nothing of it is shown";
}

TEST_F(LabelSurfacesTest, SurfacesThatAreSwitchedOffKeepTheirLabels) {
  scene::Scene scene = with({"", "2"});
  scene.surfaces[1].shown = false;
  const auto made = fields(scene);
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(labelsOf(made[0]), (std::vector<int>{1, 3}));
}

TEST_F(LabelSurfacesTest, LightIsTracedPastWhatIsSeenThrough) {
  const auto lit = [&](const scene::Scene& scene) {
    return volume::litVolume(volume_, scene, progress_)->labels->mask.labels;
  };
  scene::Scene scene = with({"", "2", "3"});
  EXPECT_EQ(volume::litVolume(volume_, scene, progress_), volume_);
  scene.surfaces[1].opacity = 0.5;
  EXPECT_EQ(lit(scene), (std::vector<int>{1, 3}));
  scene.surfaces[2].shown = false;
  EXPECT_EQ(lit(scene), (std::vector<int>{1}));
  scene.surfaces[0].opacity = 0.5;
  EXPECT_EQ(lit(scene), (std::vector<int>{1, 2})) << "none is opaque";
}

}  // namespace
}  // namespace isolux::test
