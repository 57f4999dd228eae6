// More isosurfaces than one cast follows: groups of four, and the nearest of their crossings.
#include <algorithm>
#include <cmath>
#include <random>

#include "base/color.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/surfaces.h"
#include "volume/clip/surface_cut.h"
#include "volume/hit/exact_cubic_hit.h"
#include "volume/pieces/piece_sets.h"

namespace isolux::test {
namespace {

constexpr int kVoxels = 40;

// Waves of several lengths: isosurfaces of any value between -1 and 1 have many pieces, nested in one
// another.
std::shared_ptr<const volume::PreparedVolume> nestedWaves(int voxels = kVoxels) {
  return prepared(gridOfVoxels(unitGeometry(glm::ivec3(voxels)), [voxels](glm::dvec3 p) {
    p *= static_cast<double>(kVoxels) / voxels;
    return 0.5 * std::sin(0.31 * p.x + 0.5) * std::cos(0.27 * p.y) + 0.3 * std::sin(0.23 * p.z + 0.2 * p.x) +
           0.2 * std::cos(0.35 * p.y - 0.3 * p.z);
  }));
}

// Half of them transparent, in an order that has nothing to do with their values.
scene::Scene eightSurfaces(unsigned seed) {
  constexpr double values[] = {-0.55, -0.4, -0.25, -0.1, 0.08, 0.22, 0.37, 0.52};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<int> order{0, 1, 2, 3, 4, 5, 6, 7};
  std::ranges::shuffle(order, random);
  scene::Scene scene;
  for (std::size_t i = 0; i < order.size(); ++i) {
    scene::Surface& surface = surfaceAt(scene, i);
    surface.shown = true;
    surface.value = values[order[i]];
    surface.opacity = order[i] >= 4 ? 1.0 : 0.2 + 0.5 * part(random);
    surface.albedo = {part(random), part(random), part(random)};
  }
  scene.isosurface.layers = 64;
  scene.look.mode = scene::LookMode::lambert;
  scene.look.ambient = 1.0;  // nothing but the albedo
  scene.look.backgroundTop = scene.look.backgroundBottom = glm::dvec3(0.0);
  const double turn = 0.7 * seed;
  scene.camera.target = glm::dvec3(0.5 * (kVoxels - 1));
  scene.camera.eye = *scene.camera.target + 75.0 * glm::dvec3(std::cos(turn), std::sin(turn), 0.45);
  scene.camera.up = {0.0, 0.0, 1.0};
  return scene;
}

// All crossings of a ray in double precision, surface by surface, then sorted by depth.
class SortedCrossings {
 public:
  SortedCrossings(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& scene)
      : volume_(std::move(volume)), scene_(scene), cut_(scene, volume_->grid().geometry()) {
    base::Progress progress;
    hidden_ = volume::hiddenOf(scene, *volume_->pieces, progress);
    cubic_ = volume_->cubicFields->make(scene.hit.field, progress);
  }

  glm::dvec3 colorAlong(const scene::Ray& world) const {
    const glm::dmat4 voxelFromWorld = volume_->grid().geometry().voxelFromWorld();
    volume::Ray ray;
    ray.origin = glm::dvec3(voxelFromWorld * glm::dvec4(world.origin, 1.0));
    ray.direction = glm::dmat3(voxelFromWorld) * world.direction;
    std::vector<std::pair<double, const scene::Surface*>> crossings;
    for (const scene::Surface& surface : scene_.surfaces)
      for (const auto& [begin, end] : cut_.segmentsOf(*surface.value, ray))
        add(surface, ray, begin, end, crossings);
    std::ranges::stable_sort(crossings, {}, &std::pair<double, const scene::Surface*>::first);
    glm::dvec3 color(0.0);
    double through = 1.0;
    for (const auto& [t, surface] : crossings) {
      color += through * surface->opacity * surface->albedo;
      through *= 1.0 - surface->opacity;
    }
    return color;
  }

 private:
  void add(const scene::Surface& surface, volume::Ray ray, double begin, double end,
           std::vector<std::pair<double, const scene::Surface*>>& crossings) const {
    ray.tMaximum = end;
    for (ray.tMinimum = begin; ray.tMinimum < end;) {
      const auto found = volume::firstHitOfField(volume_->grid(), scene_.hit.field,
                                                 cubic_ ? cubic_->coefficients.get() : nullptr,
                                                 cubic_ ? cubic_->blocks : *volume_->blocks, *surface.value,
                                                 ray, volume::hiddenAt(hidden_, *surface.value));
      if (!found.hit) return;
      crossings.emplace_back(found.hit->t, &surface);
      ray.tMinimum = found.hit->t + 1e-5;
    }
  }

  std::shared_ptr<const volume::PreparedVolume> volume_;
  const scene::Scene& scene_;
  std::vector<volume::HiddenOfSurface> hidden_;
  std::shared_ptr<const volume::CubicField> cubic_;
  volume::SurfaceCut cut_;
};

class MergeGlTest : public ExecutorsGlTest {
 protected:
  render::ColorImage colors(const std::shared_ptr<const volume::PreparedVolume>& volume,
                            const scene::Scene& scene, glm::ivec2 size, bool keepImages = true) {
    scene_ = scene::resolve(pinned(scene), volume->facts);
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = size;
    request.keepImages = keepImages;
    report_ = renderer_->render(scene_, request);
    return renderer_->readColor();
  }

  // The share of rays whose colour is off by more than `most` (linear light, of 1).
  double shareOff(const std::shared_ptr<const volume::PreparedVolume>& volume, const scene::Scene& scene,
                  int size, double most) {
    const render::ColorImage image = colors(volume, scene, glm::ivec2(size));
    const SortedCrossings reference(volume, scene_);
    std::size_t off = 0, seen = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const glm::dvec3 expected = reference.colorAlong(ray({x, y}, glm::ivec2(size)));
        glm::dvec3 color;
        for (int c = 0; c < 3; ++c)
          color[c] = base::decodeSrgb(image.rgba[static_cast<std::size_t>((y * size + x) * 4 + c)] / 255.0);
        seen += expected != glm::dvec3(0.0);
        off += glm::length(color - expected) > most;
      }
    EXPECT_GT(seen, static_cast<std::size_t>(size * size / 8));
    return static_cast<double>(off) / (size * size);
  }

  std::string stateOfMerge() const {
    const auto merge = std::ranges::find(report_.passes, "merge", &render::PassReport::name);
    return merge == report_.passes.end() || merge->state == render::PassState::skipped ? "skipped" : "used";
  }
};
ISOLUX_ON_BOTH_EXECUTORS(MergeGlTest);

TEST_P(MergeGlTest, EightSurfacesAreThoseOfADepthSortedReference) {
  const auto volume = nestedWaves();
  for (const unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    EXPECT_LT(shareOff(volume, eightSurfaces(seed), 184, 0.02), 0.002);  // 101 568 rays in all
    EXPECT_EQ(stateOfMerge(), "used");
  }
}

TEST_P(MergeGlTest, SoAreTheyWithCutsAndHiddenPieces) {
  const auto volume = nestedWaves();
  scene::Scene scene = eightSurfaces(4);
  scene.clip.planes = {{glm::dvec3(20.0), {0.6, -0.7, 0.4}}};
  scene.surfaces[2].clipped = scene.surfaces[5].clipped = false;
  EXPECT_LT(shareOff(volume, scene, 128, 0.02), 0.002);
  scene.pieces.smallest = 400.0;
  EXPECT_LT(shareOff(volume, scene, 128, 0.02), 0.002);
}

TEST_P(MergeGlTest, SoAreTheyOnASplineAndSampled) {
  const auto volume = nestedWaves();
  scene::Scene scene = eightSurfaces(5);
  scene.hit.field = scene::Field::cubic;
  EXPECT_LT(shareOff(volume, scene, 96, 0.02), 0.004);
  scene.hit.method = scene::HitMethod::sampled;
  scene.hit.rate = 8.0;
  EXPECT_LT(shareOff(volume, scene, 96, 0.02), 0.02);  // steps miss what rays graze
}

// Surfaces of values that the volume does not have fill the groups: pictures are those of one group.
TEST_P(MergeGlTest, GroupsThatNoRayMeetsChangeNothing) {
  const auto volume = nestedWaves();
  for (const char* setting : {"look.mode=blinn_phong", "look.shadow=1", "look.mode=mean_curvature",
                              "hit.field=cubic", "hit.method=sampled", "look.mode=gi"}) {
    SCOPED_TRACE(setting);
    scene::Scene few = eightSurfaces(6);
    few.surfaces.erase(few.surfaces.begin() + 4, few.surfaces.end());
    scene::applyAssignment(few, setting);
    scene::Scene many = few;
    many.surfaces.clear();
    for (std::size_t i = 0; i < 16; ++i) {
      many.surfaces.push_back(few.surfaces[i / 4]);
      if (i % 4 == i / 4) continue;
      many.surfaces.back().value = 5.0 + static_cast<double>(i);
      many.surfaces.back().id = "absent" + std::to_string(i);
    }
    ASSERT_EQ(many.surfaces.size(), 16u);
    const glm::ivec2 size(96, 80);
    const Images one = images(volume, few, size);
    const render::ColorImage oneColor = colors(volume, few, size);
    EXPECT_EQ(stateOfMerge(), "skipped");
    const Images all = images(volume, many, size);
    const render::ColorImage allColor = colors(volume, many, size);
    EXPECT_EQ(stateOfMerge(), "used");
    EXPECT_EQ(all.hit.values, one.hit.values);
    std::size_t different = 0, moved = 0;
    for (std::size_t i = 0; i < one.hit.values.size(); ++i) {
      moved += one.hit.values[i] == 1.0f && glm::distance(at(all.voxel, i), at(one.voxel, i)) > 1e-3;
      for (std::size_t c = 0; c < 3; ++c)
        different += std::abs(allColor.rgba[4 * i + c] - oneColor.rgba[4 * i + c]) > 2;
    }
    EXPECT_LE(moved, 5u);  // values are less that of the group's first, rounded: seen where rays graze
    EXPECT_LE(different, one.hit.values.size() / 100);  // where light grazes a surface, or two meet
  }
}

// As tiles of large pictures are drawn.
TEST_P(MergeGlTest, FramesThatKeepNoImagesAreTheSame) {
  const auto volume = nestedWaves();
  for (const char* method : {"hit.method=exact", "hit.method=sampled"}) {
    scene::Scene scene = eightSurfaces(9);
    scene::applyAssignment(scene, method);
    const render::ColorImage kept = colors(volume, scene, {96, 80}),
                             dropped = colors(volume, scene, {96, 80}, false);
    EXPECT_EQ(kept.rgba, dropped.rgba) << method;
    for (scene::Surface& surface : scene.surfaces) surface.opacity = 1.0;
    EXPECT_EQ(colors(volume, scene, {96, 80}).rgba, colors(volume, scene, {96, 80}, false).rgba) << method;
  }
}

// Of two surfaces of one value, the first is seen, in whichever group.
TEST_P(MergeGlTest, TheFirstOfTwoAtTheSamePlaceIsSeen) {
  const auto volume = nestedWaves();
  scene::Scene scene = eightSurfaces(7);
  for (scene::Surface& surface : scene.surfaces) surface.value = 0.1;
  for (scene::Surface& surface : scene.surfaces) surface.opacity = 1.0;
  scene.surfaces[0].albedo = {0.0, 1.0, 0.0};
  for (std::size_t i = 1; i < 8; ++i) scene.surfaces[i].albedo = {1.0, 0.0, 0.0};
  const render::ColorImage image = colors(volume, scene, {64, 64});
  std::size_t green = 0, red = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    green += image.rgba[i + 1] > 200;
    red += image.rgba[i] > 100;
  }
  EXPECT_GT(green, 500u);
  EXPECT_EQ(red, 0u);
}

}  // namespace

class MergeInBricksGlTest : public MergeGlTest {};
INSTANTIATE_TEST_SUITE_P(Executors, MergeInBricksGlTest, ::testing::Values("gpu"),
                         [](const auto& executor) { return std::string(executor.param); });

TEST_P(MergeInBricksGlTest, PicturesAreThoseOfAWholeTexture) {
  const auto volume = nestedWaves(100);
  for (const char* method : {"hit.method=exact", "hit.method=sampled"}) {
    SCOPED_TRACE(method);
    scene::Scene scene = assigned({method, "look.mode=blinn_phong"}, eightSurfaces(8));
    scene.camera.target = glm::dvec3(49.5);
    scene.camera.eye = {170.0, 130.0, 110.0};
    for (const int budgetMb : {2048, 5}) {
      const bool allFit = budgetMb > 100;
      // Of what lies behind transparent surfaces, what does not fit is missing, and said to be.
      for (scene::Surface& surface : scene.surfaces)
        if (!allFit) surface.opacity = 1.0;
      const render::ColorImage whole = colors(volume, scene, {96, 80});
      renderer_->setHostSettings(
          {.memory = {budgetMb, scene::MemoryLayout::bricks}, .executor = scene::Executor::gpu});
      const render::ColorImage bricks = colors(volume, scene, {96, 80});
      EXPECT_TRUE(report_.bricks.inUse);
      EXPECT_EQ(report_.bricks.evicted == 0, allFit);
      std::size_t different = 0;
      for (std::size_t i = 0; i < whole.rgba.size(); ++i)
        different += std::abs(whole.rgba[i] - bricks.rgba[i]) > 1;
      EXPECT_EQ(different, 0u);
      renderer_->setHostSettings(host_);
    }
  }
}

}  // namespace isolux::test
