// Surface points of a label map have the label and the colour of where they lie, with both executors.
#include <cmath>
#include <set>

#include "base/color.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/label_volumes.h"

namespace isolux::test {
namespace {

using render::Aov;

class LabelGlTest : public ExecutorsGlTest {
 protected:
  struct Drawn {
    std::vector<float> hit, label;
    render::AovImage voxel;
    render::ColorImage color;
  };
  Drawn draw(const std::shared_ptr<const volume::PreparedVolume>& volume, scene::Scene scene) {
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = {120, 100};
    request.aovs = {Aov::hit, Aov::voxel, Aov::label};
    renderer_->render(scene::resolve(scene, volume->facts), request);
    return {renderer_->readAov(Aov::hit).values, renderer_->readAov(Aov::label).values,
            renderer_->readAov(Aov::voxel), renderer_->readColor()};
  }
};
ISOLUX_ON_BOTH_EXECUTORS(LabelGlTest);

TEST_P(LabelGlTest, EachPointHasTheLabelWhereItLies) {
  for (const char* shown : {"", "1,3", "2"}) {
    const auto volume = loadedLabels(threeLabels(), shown);
    const Drawn drawn = draw(volume, {});
    std::set<int> seen;
    for (std::size_t i = 0; i < drawn.hit.size(); ++i) {
      ASSERT_EQ(drawn.hit[i] == 1.0f, !std::isnan(drawn.label[i])) << i;
      if (drawn.hit[i] != 1.0f) continue;
      const float* const p = &drawn.voxel.values[3 * i];
      ASSERT_EQ(static_cast<int>(drawn.label[i]), volume::labelAt(*volume->labels, {p[0], p[1], p[2]})) << i;
      seen.insert(static_cast<int>(drawn.label[i]));
    }
    EXPECT_EQ(std::vector<int>(seen.begin(), seen.end()), volume->labels->mask.labels) << shown;
  }
}

// Under light without colour, a pixel's channels are in the ratio of its label's.
TEST_P(LabelGlTest, EachPointHasTheColourOfItsLabel) {
  const auto volume = loadedLabels(threeLabels());
  const Drawn drawn = draw(volume, assigned({"look.mode=lambert", "look.occlusion=0"}));
  int compared = 0;
  for (std::size_t i = 0; i < drawn.hit.size(); ++i) {
    if (drawn.hit[i] != 1.0f) continue;
    const glm::vec3 label = volume::labelColor(nullptr, static_cast<int>(drawn.label[i]));
    glm::vec3 color;
    for (int c = 0; c < 3; ++c)
      color[c] =
          static_cast<float>(base::decodeSrgb(drawn.color.rgba[4 * i + static_cast<std::size_t>(c)] / 255.0));
    const float brightness = color.r + color.g + color.b;
    if (brightness < 0.3f || std::max({color.r, color.g, color.b}) > 0.95f) continue;
    const glm::vec3 wanted = label * (brightness / (label.r + label.g + label.b));
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(color[c], wanted[c], 0.02f) << i;
    ++compared;
  }
  EXPECT_GT(compared, 300);
}

// Cut open, labels show their colours, those that are not shown grey where the whole volume is capped.
TEST_P(LabelGlTest, CapsHaveTheColoursOfLabels) {
  const auto volume = loadedLabels(threeLabels(), "1,3");
  for (const bool whole : {false, true}) {
    scene::Scene scene = assigned({"look.mode=lambert", whole ? "clip.cap=whole" : "clip.cap=inside"});
    const glm::dvec3 first(14.0, 18.0, 18.0), normal(0.0, -0.678, 0.735);  // a plane through all three balls
    scene.clip.planes = {{first, normal}};
    scene.camera.target = glm::dvec3(25.0, 22.0, 22.0);
    scene.camera.eye = *scene.camera.target + 70.0 * normal;
    scene.camera.up = {0.0, 0.735, 0.678};
    const Drawn drawn = draw(volume, scene);
    const auto pixelsOf = [&](const glm::vec3& color) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < drawn.color.rgba.size(); i += 4) {
        bool same = true;
        for (std::size_t c = 0; c < 3; ++c)
          same =
              same && std::abs(drawn.color.rgba[i + c] - base::screenByte(color[static_cast<int>(c)])) <= 1;
        count += same;
      }
      return count;
    };
    for (const int label : {1, 3})
      EXPECT_GT(pixelsOf(volume::labelColor(nullptr, label)), 30u) << label << ' ' << whole;
    EXPECT_EQ(pixelsOf(volume::labelColor(nullptr, 2)), 0u) << whole;
    EXPECT_EQ(pixelsOf(volume::faceColor(*volume->labels, 2)) > 30u, whole);
  }
}

}  // namespace
}  // namespace isolux::test
