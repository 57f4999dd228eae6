// Pictures of random fields (tests/properties) through the whole renderer: no NaN and no infinity in any
// image, and what the images say of a hit agrees.
#include <algorithm>
#include <cmath>
#include <sstream>

#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/properties/property_run.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

class PropertiesGlTest : public ExecutorsGlTest {
 protected:
  // Settings by the case's seed. Shaders: always the same ones, because a driver takes seconds to compile
  // others; hard_cases_gl_test.cpp has them all.
  static std::vector<std::string> settingsOf(const PropertyCase& made) {
    if (std::string_view(GetParam()) == "gpu")
      return {"hit.method=exact", "hit.field=trilinear", "derivatives.field=cubic",
              "look.mode=mean_curvature"};
    const auto pick = [&](std::uint64_t which, std::initializer_list<const char*> choices) {
      return std::string(choices.begin()[base::counterHash(made.seed, which) % choices.size()]);
    };
    return {"hit.method=exact",
            pick(1, {"hit.field=trilinear", "hit.field=cubic", "hit.field=cubic_interpolating"}),
            pick(2, {"derivatives.field=cubic", "derivatives.field=cubic_interpolating"}),
            pick(3, {"look.mode=lambert", "look.mode=normal", "look.mode=mean_curvature", "look.mode=depth"}),
            pick(4, {"look.shadow=0", "look.shadow=1"}),
            pick(5, {"isosurface.opacity=1", "isosurface.opacity=0.5"}),
            pick(6, {"look.contours=0", "look.contours=1"}),
            pick(7, {"isosurface.inside=above", "isosurface.inside=below"})};
  }

  std::string imagesAreFinite(const PropertyCase& made) {
    const auto volume = prepared(made.grid());
    scene::Scene scene = assigned(settingsOf(made));
    scene.surfaces.front().value = made.isovalueIn(volume->grid());
    scene.camera = made.camera(volume->grid().geometry());
    const Images result = images(volume, scene, made.picture);
    for (const render::AovInfo& info : render::aovs()) {
      const render::AovImage image = renderer_->readAov(info.aov);
      const std::size_t channels = image.values.size() / result.hit.values.size();
      for (std::size_t i = 0; i < image.values.size(); ++i) {
        // NaN says that there is nothing to say; infinity says nothing.
        if (std::isinf(image.values[i]))
          return wrongAt("infinite", std::string(info.name), i / channels, made);
      }
    }
    const render::AovImage gradient = renderer_->readAov(render::Aov::gradient),
                           kappa = renderer_->readAov(render::Aov::kappa);
    for (std::size_t i = 0; i < result.hit.values.size(); ++i) {
      if (result.hit.values[i] != 1.0f) continue;
      const glm::dvec3 voxel = at(result.voxel, i), position = at(result.position, i);
      if (!std::isfinite(voxel.x + voxel.y + voxel.z + position.x + position.y + position.z) ||
          !std::isfinite(result.depth.values[i]) || !std::isfinite(result.error.values[i]))
        return wrongAt("a hit that is not finite", "voxel, position, depth, error", i, made);
      const glm::dvec3 g = at(gradient, i);
      if (!std::isfinite(g.x + g.y + g.z) || !std::isfinite(kappa.values[2 * i]) ||
          !std::isfinite(kappa.values[2 * i + 1]))
        return wrongAt("a hit that is not finite", "gradient, kappa", i, made);
      const glm::dvec3 outside = glm::max(-voxel, voxel - glm::dvec3(made.dims - 1));
      if (std::max({outside.x, outside.y, outside.z}) > 1e-2)
        return wrongAt("a hit outside of the volume", "voxel", i, made);
    }
    const render::LinearImage linear = renderer_->readLinear();
    for (std::size_t i = 0; i < linear.rgba.size(); ++i)
      if (!(linear.rgba[i] >= 0.0f && linear.rgba[i] < (i % 4 == 3 ? 1.001f : 65504.0f)))
        return wrongAt("no colour", exactText(static_cast<double>(linear.rgba[i])), i / 4, made);
    return {};
  }

 private:
  static std::string wrongAt(const char* what, const std::string& where, std::size_t pixel,
                             const PropertyCase& made) {
    std::ostringstream text;
    text << what << ": " << where << ", pixel " << pixel % static_cast<std::size_t>(made.picture.x) << ' '
         << pixel / static_cast<std::size_t>(made.picture.x);
    for (const std::string& setting : settingsOf(made)) text << ' ' << setting;
    return text.str();
  }
};

TEST_P(PropertiesGlTest, ImagesAreFinite) {
  expectHolds("ImagesAreFinite", 0.09, [&](const PropertyCase& made) { return imagesAreFinite(made); });
}

ISOLUX_ON_BOTH_EXECUTORS(PropertiesGlTest);

}  // namespace
}  // namespace isolux::test
