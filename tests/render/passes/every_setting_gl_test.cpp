// Every setting of the list, changed in every look: exactly the passes whose images change run, and what the
// others keep is what a renderer without memory draws.
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "gi/ground/ground_shadow.h"
#include "scene/rules/relevance.h"
#include "scene/settings/settings.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/light/light_support.h"
#include "tests/scene/random_scene.h"

namespace isolux::test {

namespace {

using nlohmann::json;
using Hashes = std::map<std::string, std::uint64_t>;

// Values that are sure to be seen on this volume.
const std::map<std::string, const char*> kValues = {
    {"look.ridge_length", "150"},  // mm: more than some lines of a head have

    {"surfaces.main.value", "0.3"},       {"surfaces.surface2.value", "0.6"},
    {"surfaces.surface3.value", "-0.6"},  {"edge.contrast", "1e6"},
    {"hit.near_threshold", "0"},          {"look.colormap", "inferno"},
    {"clip.planes", "0,0,2 0.1,0.2,1"},   {"clip.box", "-6,-7,-8; 7,6,5"},
    {"clip.removed", "0,-1,1; 90,90,90"},
};

// Another valid value of the setting, far enough from that of the scene to be seen.
json changedValue(const scene::Setting& s, const scene::Scene& scene) {
  const json now = s.get(scene);
  switch (s.type) {
    case scene::SettingType::number: {
      const double value = now.is_number() ? now.get<double>() : 0.0;
      if (s.maximum - s.minimum <= 1.0) return value < 0.5 ? value + 0.43 : value - 0.41;
      const double more = value * 1.5 + 0.1;
      return more <= s.maximum ? more : value * 0.5;
    }
    case scene::SettingType::integer: {
      const int value = now.is_number() ? now.get<int>() : 1;
      return value > s.minimum ? static_cast<int>(s.minimum) : value + 1;
    }
    case scene::SettingType::choice: {
      const auto at = std::find(s.choices.begin(), s.choices.end(), now.get<std::string>());
      return at + 1 == s.choices.end() ? s.choices.front() : *(at + 1);
    }
    case scene::SettingType::vector: {
      if (!s.path.starts_with("camera.")) return {0.25, 0.5, 0.125};
      json moved = now;
      for (int i = 0; i < 3; ++i) moved[static_cast<std::size_t>(i)] = now[i].get<double>() + 0.7 * (i - 0.6);
      return moved;
    }
    case scene::SettingType::pair:
      return {0.25, 0.5};
    case scene::SettingType::quaternion:
      return {0.25, 0.5, 0.125, 0.75};
    case scene::SettingType::toggle:
      return !now.get<bool>();
    case scene::SettingType::points:
      return json::array({{0.5, -0.5, 0.25, 0.5, 1.0}, {-0.5, -0.5, 1.0, 0.5, 0.0}});
    case scene::SettingType::color_points:
      return json::array({{0.0, 0.25, 0.5, 1.0}, {1.0, 1.0, 0.5, 0.25}});
    case scene::SettingType::planes:
      return json::array({{1.0, -2.5, 3.0, 0.0, 0.6, -0.8}});
    case scene::SettingType::marks:
      return json::array({{{"kind", "point"}, {"name", "a"}, {"points", {{1.0, -2.5, 3.0}}}}});
    case scene::SettingType::positions:
      return json::array({{1.0, -2.5, 3.0}, {4.0, 5.0, 6.0}});
    case scene::SettingType::item:
    case scene::SettingType::ids:
    case scene::SettingType::text:
      break;
  }
  return "other";
}

void setOther(const scene::Setting& setting, scene::Scene& scene) {
  const auto given = kValues.find(setting.path);
  if (given != kValues.end())
    scene::applyAssignment(scene, setting.path + "=" + given->second);
  else
    setting.set(scene, changedValue(setting, scene));
}

// What changes nothing in pictures as small as these, though it does in others.
bool tooFineToSee(const std::string& pass, const std::string& path) {
  static const std::map<std::string, std::set<std::string>> table = {
      {"look.legend", {"resolve"}},  // there is no room for one
      {"look.legend_corner", {"resolve"}},
      {"isosurface.inside",
       {"lines", "piece"}},               // outlines, and pieces of a gyroid, are the same from both sides
      {"derivatives.fetch", {"layers"}},  // roundings, less than a half float's step in what is laid over
      {"look.suggestive_contours", {"lines", "shade", "layers"}}};  // of rays a ninetieth of the height apart
  const auto at = table.find(path);
  return at != table.end() && at->second.contains(pass);
}

class EverySettingGlTest : public RenderGlTest, public ::testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    RenderGlTest::SetUp();
    request_.size = {36, 27};
    volume_ = phantom("gyroid", 24);
    renderer_->setVolume(volume_);
    fresh_ = std::make_unique<render::Renderer>(context_->gl());
    fresh_->setVolume(volume_);
  }
  void TearDown() override {
    fresh_.reset();
    RenderGlTest::TearDown();
  }

  struct Drawn {
    Hashes images;
    std::map<std::string, std::string> ran;  // why
  };
  Drawn draw(render::Renderer& renderer, const scene::Scene& scene) const {
    Drawn drawn;
    for (const render::PassReport& pass : renderer.render(scene, request_).passes)
      if (pass.state == render::PassState::ran) drawn.ran[pass.name] = pass.reason;
    drawn.images = renderer.imageHashes();
    return drawn;
  }
  Drawn drawnFresh(const scene::Scene& scene) {
    fresh_->invalidate();
    return draw(*fresh_, scene);
  }

  // `setting` changes from a scene whose pictures are known.
  void change(const scene::Setting& setting, const scene::Scene& before, const Hashes& imagesBefore) {
    scene::Scene after = before;
    setOther(setting, after);
    ASSERT_NE(setting.get(after), setting.get(before));
    const Drawn changed = draw(*renderer_, after);
    if (changed.ran.empty()) {
      setWithOthers(setting, before, imagesBefore);
      return;
    }
    const Drawn fresh = drawnFresh(after);
    for (const auto& [pass, hash] : fresh.images) {
      EXPECT_EQ(changed.images.at(pass), hash) << pass << " kept an old image";
      const auto was = imagesBefore.find(pass);
      const auto ran = changed.ran.find(pass);
      if (was == imagesBefore.end() || was->second != hash || ran == changed.ran.end()) continue;
      if (tooFineToSee(pass, setting.path)) continue;
      EXPECT_EQ(ran->second.find("changed"), std::string::npos)
          << pass << " ran although nothing of its images changes: " << ran->second;
    }
    EXPECT_EQ(draw(*renderer_, before).images, imagesBefore) << "on the way back";
  }

  // Settings that cost nothing are changed together: none of them may change an image. One that acts where
  // others have been changed is tried alone.
  void setWithOthers(const scene::Setting& setting, const scene::Scene& before, const Hashes& imagesBefore) {
    if (scene::whyInactive(setting.path, together_).empty()) {
      scene::Scene alone = before;
      setOther(setting, alone);
      EXPECT_EQ(drawnFresh(alone).images, imagesBefore) << "no pass ran";
    } else {
      setOther(setting, together_);
    }
  }

  static bool isOfRidges(const std::string& path) {
    return path.starts_with("look.ridge") || path == "look.valley_color";
  }

  // A gyroid bends as much one way as the other: it has no ridges, and what is set of them is another test's.
  void changeEverySetting(const std::vector<const char*>& assignments, bool ofRidges = false) {
    scene::Scene scene;
    for (const char* assignment : assignments) scene::applyAssignment(scene, assignment);
    scene::setting("look.mode").set(scene, GetParam());
    scene = scene::resolve(pinned(std::move(scene)), volume_->facts);
    together_ = scene;
    const Hashes images = drawnFresh(scene).images;
    ASSERT_EQ(draw(*renderer_, scene).images, images);
    for (const scene::Setting& setting : everySetting(scene)) {
      SCOPED_TRACE(setting.path);
      if (isOfRidges(setting.path) != ofRidges) continue;
      change(setting, scene, images);
    }
    EXPECT_EQ(drawnFresh(together_).images, images) << "settings that no pass depends on";
  }

  std::shared_ptr<const volume::PreparedVolume> volume_;
  std::unique_ptr<render::Renderer> fresh_;  // draws everything each time
  render::FrameRequest request_;
  scene::Scene together_;
};

TEST_P(EverySettingGlTest, ChangesThePassesThatRun) {
  changeEverySetting({"look.ridge_threshold=0.02", "derivatives.noise=0"});
}

TEST_P(EverySettingGlTest, ChangesThePassesThatRunWithEverythingLaidOver) {
  changeEverySetting({"derivatives.noise=0", "hit.method=sampled", "hit.refinements=1",
                      "isosurface.opacity=0.6", "isosurface2.shown=true", "isosurface2.value=0.5",
                      "isosurface2.opacity=1", "look.shadow=0.5", "look.fog=0.5", "look.texture=marble",
                      "look.accessibility=0.4", "look.ridges=0.5", "look.ridge_threshold=0.02",
                      "look.contours=0.6", "look.suggestive_contours=0.5", "flow.strength=0.5",
                      "flow.time=0.3"});
}

class EverySettingOfRidgesGlTest : public EverySettingGlTest {};

TEST_P(EverySettingOfRidgesGlTest, ChangesThePassesThatRun) {
  volume_ = phantom("head", 32);
  renderer_->setVolume(volume_);
  fresh_->setVolume(volume_);
  const std::vector<const char*> lines = {"derivatives.noise=0", "look.ridge_threshold=0.02",
                                          "look.ridge_length=3", "look.ridges=0.5"};
  changeEverySetting(lines, true);
}

// Deferred images read what the look may not.
class EverySettingOfDeferredImagesGlTest : public EverySettingGlTest {};

TEST_P(EverySettingOfDeferredImagesGlTest, ChangesThePassesThatRun) {
  request_.color = false;
  for (const render::AovInfo& info : render::aovs()) request_.aovs.push_back(info.aov);
  changeEverySetting({"hit.method=sampled", "hit.refinements=1"});
}

// Curvature and normals have scales of their own, or the same one, or none.
class EverySettingAtScalesGlTest : public EverySettingGlTest {};

TEST_P(EverySettingAtScalesGlTest, ChangesThePassesThatRun) {
  for (const auto& [scale, normalScale] : {std::pair("derivatives.scale=0.5", "derivatives.normal_scale=0.4"),
                                           std::pair("derivatives.scale=0.5", "derivatives.normal_scale=0.5"),
                                           std::pair("derivatives.scale=0", "derivatives.normal_scale=0")})
    changeEverySetting({"look.ridge_threshold=0.02", "derivatives.noise=0.01", scale, normalScale});
}

class EverySettingWithStoredLightGlTest : public EverySettingGlTest {};

TEST_P(EverySettingWithStoredLightGlTest, ChangesThePassesThatRun) {
  const auto latticeOf = [&](float least) {
    auto lattice = emptyLattice(volume_->grid().dims(), 1.0);
    writeAll(*lattice, [least](glm::ivec3 texel) {
      TexelLight light;
      light.normal = glm::normalize(glm::vec3(texel % 3) - glm::vec3(0.9f));
      for (int i = 0; i < 3; ++i) light.means.push_back(least + 0.03f * static_cast<float>(texel[i]));
      return light;
    });
    return lattice;
  };
  const auto light = pictureLight(latticeOf(1.0f));
  light->inner.sky = latticeOf(0.5f);
  light->irradianceSh[0] = glm::vec3(1.0f);  // local light, that comes through transparent surfaces
  auto ground = std::make_shared<gi::GroundShadow>();
  ground->key = 1;
  ground->middleMm = {0.0, 0.0, -40.0};
  ground->rightMm = {500.0, 0.0, 0.0};
  ground->backMm = {0.0, 500.0, 0.0};
  ground->light.assign(gi::GroundShadow::kPoints * gi::GroundShadow::kPoints, 0.5f);
  light->ground = ground;
  for (render::Renderer* renderer : {renderer_.get(), fresh_.get()}) renderer->setLight(light);
  changeEverySetting({"look.ridge_threshold=0.02", "look.shading=gi", "gi.interpolation=trilinear",
                      "picture.exposure=3",  // as bright as the shoulder of the tone curve
                      "gi.ground=true"});
}

const auto kNameOfLook = [](const auto& look) { return look.param; };
INSTANTIATE_TEST_SUITE_P(Looks, EverySettingGlTest, ::testing::ValuesIn(scene::setting("look.mode").choices),
                         kNameOfLook);
INSTANTIATE_TEST_SUITE_P(Looks, EverySettingOfRidgesGlTest,
                         ::testing::Values("lambert", "kappa1", "flow", "depth"), kNameOfLook);
INSTANTIATE_TEST_SUITE_P(Looks, EverySettingOfDeferredImagesGlTest, ::testing::Values("lambert", "depth"),
                         kNameOfLook);
INSTANTIATE_TEST_SUITE_P(Looks, EverySettingAtScalesGlTest, ::testing::Values("lambert", "kappa1", "flow"),
                         kNameOfLook);
INSTANTIATE_TEST_SUITE_P(Looks, EverySettingWithStoredLightGlTest, ::testing::Values("gi", "kappa1"),
                         kNameOfLook);

}  // namespace

}  // namespace isolux::test
