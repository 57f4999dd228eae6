// Surfaces that show labels of their own: a field each, cast one after another, against a reference that
// sorts their crossings by depth.
#include <algorithm>
#include <cmath>
#include <random>

#include "base/color.h"
#include "scene/shown_surfaces.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/label_volumes.h"
#include "tests/support/surfaces.h"
#include "volume/clip/surface_cut.h"
#include "volume/hit/exact_cubic_hit.h"
#include "volume/labels/label_table.h"
#include "volume/pieces/piece_sets.h"

namespace isolux::test {
namespace {

constexpr int kLabelVoxels = 40;

// A large ball of label 5 that holds two that touch, 1 and 2, and is touched by 3 from outside; 4 is apart.
volume::Grid nestedLabels() {
  return gridOfLabels(glm::ivec3(kLabelVoxels), {{{14.0, 20.0, 19.0}, 5.5},
                                                 {{24.0, 19.0, 21.0}, 5.0},
                                                 {{20.0, 34.0, 20.0}, 4.5},
                                                 {{35.0, 34.0, 33.0}, 3.5},
                                                 {{19.5, 18.5, 20.0}, 13.5}});
}

scene::Surface& labelSurface(scene::Scene& scene, std::size_t at, const char* labels, double opacity) {
  scene::Surface& surface = surfaceAt(scene, at);
  surface.shown = true;
  surface.labels = labels;
  surface.opacity = opacity;
  surface.labelColors = false;
  return surface;
}

// Surfaces of 1, of 2 and 3, of 5, and of what is left, in an order of no meaning.
scene::Scene fourSurfaces(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0.1, 1.0);
  scene::Scene scene;
  labelSurface(scene, 0, "2,3", 0.3 + 0.4 * part(random));
  labelSurface(scene, 1, "", 1.0);
  labelSurface(scene, 2, "5", 0.2 + 0.3 * part(random));
  labelSurface(scene, 3, "1", seed % 2 == 0 ? 1.0 : 0.5);
  for (scene::Surface& surface : scene.surfaces) surface.albedo = {part(random), part(random), part(random)};
  scene.isosurface.layers = 64;
  scene.look.mode = scene::LookMode::lambert;
  scene.look.ambient = 1.0;  // nothing but the albedo
  scene.look.backgroundTop = scene.look.backgroundBottom = glm::dvec3(0.0);
  const double turn = 0.7 * seed;
  scene.camera.target = glm::dvec3(0.5 * (kLabelVoxels - 1));
  scene.camera.eye = *scene.camera.target + 75.0 * glm::dvec3(std::cos(turn), std::sin(turn), 0.45);
  scene.camera.up = {0.0, 0.0, 1.0};
  return scene;
}

// All crossings of a ray in double precision, field by field, then sorted by depth.
class SortedSolids {
 public:
  SortedSolids(const volume::PreparedVolume& volume, const scene::Scene& scene)
      : scene_(scene),
        surfaces_(scene::visibleSurfaces(scene)),
        fields_(volume::labelFields(volume, scene, progress_)) {
    for (const scene::Surface& surface : surfaces_) {
      scene::Scene alone = scene;
      alone.surfaces = {surface};
      cuts_.emplace_back(alone, volume.grid().geometry());
    }
    for (const auto& field : fields_)
      hidden_.push_back(field ? volume::hiddenOf(scene, *field->pieces, progress_)
                              : std::vector<volume::HiddenOfSurface>());
  }
  std::size_t fields() const { return fields_.size(); }

  glm::dvec3 colorAlong(const volume::Ray& ray) const {
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (fields_[i])
        for (const auto& [begin, end] : cuts_[i].segmentsOf(0.0, ray)) add(i, ray, begin, end, crossings);
    std::ranges::stable_sort(crossings, {}, &Crossing::t);
    const glm::dvec3 steps = glm::abs(ray.direction);
    const double half = 0.5 / std::max({steps.x, steps.y, steps.z});
    glm::dvec3 color(0.0);
    double through = 1.0;
    for (const Crossing& one : crossings) {
      const bool isJoined = !one.enters && std::ranges::any_of(crossings, [&](const Crossing& other) {
        return other.enters && other.surface != one.surface && std::abs(other.t - one.t) <= half;
      });
      if (isJoined) continue;
      const scene::Surface& surface = surfaces_[one.surface];
      color += through * surface.opacity * surface.albedo;
      through *= 1.0 - surface.opacity;
    }
    return color;
  }

 private:
  struct Crossing {
    double t = 0.0;
    std::size_t surface = 0;
    bool enters = false;
  };
  void add(std::size_t i, volume::Ray ray, double begin, double end, std::vector<Crossing>& crossings) const {
    const volume::PreparedVolume& field = *fields_[i];
    ray.tMaximum = end;
    for (ray.tMinimum = begin; ray.tMinimum < end;) {
      const auto found = volume::firstHitOfField(field.grid(), scene::Field::trilinear, nullptr,
                                                 *field.blocks, 0.0, ray, volume::hiddenAt(hidden_[i], 0.0));
      if (!found.hit) return;
      const glm::dvec3 behind = ray.origin + (found.hit->t + 1e-4) * ray.direction;
      crossings.push_back({found.hit->t, i, volume::sampleTrilinear(field.grid(), behind).value >= 0.0});
      ray.tMinimum = found.hit->t + 1e-5;
    }
  }

  base::Progress progress_;
  const scene::Scene& scene_;
  std::vector<scene::Surface> surfaces_;
  volume::LabelSurfaces::Fields fields_;
  std::vector<std::vector<volume::HiddenOfSurface>> hidden_;
  std::vector<volume::SurfaceCut> cuts_;
};

class LabelSurfacesGlTest : public ExecutorsGlTest {
 protected:
  void SetUp() override {
    ExecutorsGlTest::SetUp();
    volume_ = loadedLabels(nestedLabels());
  }
  render::ColorImage colors(const scene::Scene& scene, glm::ivec2 size, bool keepImages = true) {
    scene_ = scene::resolve(pinned(scene), volume_->facts);
    renderer_->setVolume(volume_);
    render::FrameRequest request;
    request.size = size;
    request.keepImages = keepImages;
    report_ = renderer_->render(scene_, request);
    return renderer_->readColor();
  }
  static glm::dvec3 linearAt(const render::ColorImage& image, std::size_t pixel) {
    glm::dvec3 color;
    for (std::size_t c = 0; c < 3; ++c)
      color[static_cast<int>(c)] = base::decodeSrgb(image.rgba[4 * pixel + c] / 255.0);
    return color;
  }

  // The share of rays whose colour is off by more than 0.02 (linear light, of 1).
  double shareOff(const scene::Scene& scene, int size) {
    const render::ColorImage image = colors(scene, glm::ivec2(size));
    const SortedSolids reference(*volume_, scene_);
    EXPECT_EQ(reference.fields(), scene_.surfaces.size());
    const glm::dmat4 voxelFromWorld = volume_->grid().geometry().voxelFromWorld();
    std::size_t off = 0, seen = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const scene::Ray world = ray({x, y}, glm::ivec2(size));
        volume::Ray own;
        own.origin = glm::dvec3(voxelFromWorld * glm::dvec4(world.origin, 1.0));
        own.direction = glm::dmat3(voxelFromWorld) * world.direction;
        const glm::dvec3 expected = reference.colorAlong(own);
        const glm::dvec3 color = linearAt(image, static_cast<std::size_t>(y * size + x));
        seen += expected != glm::dvec3(0.0);
        off += glm::length(color - expected) > 0.02;
      }
    EXPECT_GT(seen, static_cast<std::size_t>(size * size / 8));
    return static_cast<double>(off) / (size * size);
  }

  std::shared_ptr<const volume::PreparedVolume> volume_;
};
ISOLUX_ON_BOTH_EXECUTORS(LabelSurfacesGlTest);

TEST_P(LabelSurfacesGlTest, TheyAreThoseOfADepthSortedReference) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    EXPECT_LT(shareOff(fourSurfaces(seed), 160), 0.003);
  }
}

TEST_P(LabelSurfacesGlTest, SoAreTheyWithCutsAndHiddenPieces) {
  scene::Scene scene = fourSurfaces(4);
  scene.clip.cap = scene::ClipCap::none;
  scene.clip.planes = {{glm::dvec3(20.0), {0.6, -0.7, 0.4}}};
  scene.surfaces[2].clipped = false;
  EXPECT_LT(shareOff(scene, 128), 0.003);
  scene.pieces.keep = 1;
  EXPECT_LT(shareOff(scene, 128), 0.003);
}

// The same surface, whether its field is the volume's or its own, in every look.
TEST_P(LabelSurfacesGlTest, AFieldOfItsOwnChangesNoPictureOfOneSurface) {
  for (const char* setting : {"look.mode=blinn_phong", "look.shadow=1", "look.mode=mean_curvature",
                              "hit.field=cubic", "hit.method=sampled"}) {
    SCOPED_TRACE(setting);
    scene::Scene together = assigned({setting});
    together.look.rangeLow = -0.3;  // automatic ranges are those of each surface
    together.look.rangeHigh = 0.3;
    scene::Scene apart = together;
    volume_ = loadedLabels(nestedLabels(), "4,5");
    const render::ColorImage one = colors(together, {96, 80});
    volume_ = loadedLabels(nestedLabels());
    apart.surfaces.front().labels = "5";
    scene::Surface other = scene::newSurface(1);
    other.id = "four";
    other.labels = "4";
    apart.surfaces.push_back(other);
    apart.camera = scene_.camera;
    const render::ColorImage two = colors(apart, {96, 80});
    std::size_t different = 0;
    for (std::size_t i = 0; i < one.rgba.size(); ++i) different += std::abs(one.rgba[i] - two.rgba[i]) > 2;
    EXPECT_LE(different, one.rgba.size() / 100);
  }
}

TEST_P(LabelSurfacesGlTest, EachLabelHasItsColourOrItsSurfaces) {
  scene::Scene scene = fourSurfaces(2);
  for (scene::Surface& surface : scene.surfaces) surface.opacity = 1.0;
  scene.surfaces[2].labelColors = true;
  const glm::ivec2 size(64);
  const render::ColorImage image = colors(scene, size);
  const glm::dvec3 middle = linearAt(image, static_cast<std::size_t>(32 * 64 + 32));
  const glm::dvec3 five(volume::labelColor(nullptr, 5));
  EXPECT_LT(glm::length(middle - five), 0.02);
  scene.surfaces[2].labelColors = false;
  const glm::dvec3 own = linearAt(colors(scene, size), static_cast<std::size_t>(32 * 64 + 32));
  EXPECT_LT(glm::length(own - scene.surfaces[2].albedo), 0.02);
}

// Two that touch flatly, both seen through: one skin lies between them, not two.
TEST_P(LabelSurfacesGlTest, NeighboursHaveOneSkinBetweenThem) {
  std::vector<std::uint8_t> voxels(24 * 24 * 24);
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const glm::ivec3 at = volume::Extent3{glm::ivec3(24)}.at(i);
    const bool inside =
        glm::all(glm::greaterThan(at, glm::ivec3(4))) && glm::all(glm::lessThan(at, glm::ivec3(19)));
    if (inside) voxels[i] = at.x < 12 ? 1 : 2;
  }
  volume_ = loadedLabels(volume::Grid(unitGeometry(glm::ivec3(24)), std::move(voxels)));
  scene::Scene scene = fourSurfaces(2);
  scene.surfaces.resize(2);
  for (scene::Surface& surface : scene.surfaces) {
    surface.opacity = 0.5;
    surface.albedo = glm::dvec3(1.0);
  }
  scene.surfaces[0].labels = "1";
  scene.camera.target = glm::dvec3(11.5);
  scene.camera.eye = glm::dvec3(-60.0, 11.5, 11.5);
  // Front, middle and back: three skins hide 7/8. With two in the middle it were 15/16.
  const glm::dvec3 color = linearAt(colors(scene, {32, 32}), 16 * 32 + 16);
  EXPECT_NEAR(color.x, 0.875, 0.01);
}

TEST_P(LabelSurfacesGlTest, AHiddenSurfaceHidesItsLabels) {
  scene::Scene scene = fourSurfaces(2);
  scene.surfaces[2].shown = false;  // the ball around the others
  for (scene::Surface& surface : scene.surfaces) surface.opacity = 1.0;
  const Images seen = images(volume_, scene, {96, 96});
  EXPECT_EQ(scene::visibleSurfaces(scene_).size(), 3u);
  const std::vector<float> labels = renderer_->readAov(render::Aov::label).values;
  EXPECT_TRUE(std::ranges::none_of(labels, [](float label) { return label == 5.0f; }));
  EXPECT_TRUE(std::ranges::any_of(labels, [](float label) { return label == 1.0f; }));
  EXPECT_TRUE(std::ranges::any_of(seen.hit.values, [](float hit) { return hit == 1.0f; }));
}

// As tiles of large pictures are drawn.
TEST_P(LabelSurfacesGlTest, FramesThatKeepNoImagesAreTheSame) {
  const scene::Scene scene = fourSurfaces(3);
  EXPECT_EQ(colors(scene, {96, 80}).rgba, colors(scene, {96, 80}, false).rgba);
}

// Cut faces are those of opaque surfaces.
TEST_P(LabelSurfacesGlTest, ACutFillsOpaqueLabelsAlone) {
  scene::Scene scene = fourSurfaces(2);
  scene.surfaces[3].opacity = 1.0;  // label 1
  scene.surfaces[0].opacity = 0.3;  // 2 and 3
  scene.clip.planes = {{glm::dvec3(0.0, 0.0, 20.0), {0.0, 0.0, 1.0}}};
  scene.camera.eye = glm::dvec3(19.5, 19.6, 100.0);
  scene.camera.up = {0.0, 1.0, 0.0};
  const render::ColorImage image = colors(scene, {80, 80});
  const auto has = [&](const glm::dvec3& color) {
    for (std::size_t i = 0; i < 80u * 80u; ++i)
      if (glm::length(linearAt(image, i) - color) < 0.03) return true;
    return false;
  };
  EXPECT_TRUE(has(scene.surfaces[3].albedo));
  EXPECT_FALSE(has(scene.surfaces[0].albedo));
  EXPECT_FALSE(has(scene.surfaces[2].albedo));
}

}  // namespace
}  // namespace isolux::test
