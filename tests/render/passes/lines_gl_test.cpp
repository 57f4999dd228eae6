// Lines of curvature in the picture, against closed forms: where they run, how wide they are, that they are
// whole.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/render/gl_fixture.h"
#include "volume/phantom/phantom.h"

namespace isolux::test {
namespace {

// Ridges are drawn in red, valleys in blue, on black: colours are coverages.
class LinesGlTest : public RenderGlTest {
 protected:
  void draw(const std::shared_ptr<const volume::PreparedVolume>& volume,
            const std::vector<std::string>& settings, double mmPerPixel, glm::ivec2 size = {128, 128}) {
    scene::Scene scene =
        assigned({"look.mode=lambert", "look.ambient=1", "isosurface.albedo=0,0,0", "look.ridges=1",
                  "look.ridge_color=1,0,0", "look.valley_color=0,0,1", "isosurface.value=0",
                  "derivatives.scale=0", "derivatives.normal_scale=0"});
    scene.camera.projection = scene::Projection::orthographic;
    centre_ = 0.5 * (volume->facts.boundsMinMm + volume->facts.boundsMaxMm);
    scene.camera.target = centre_;
    scene.camera.eye = centre_ - glm::dvec3(0.0, 400.0, 0.0);
    scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
    scene.camera.fov = 2.0 * std::atan(0.5 * size.y * mmPerPixel / 400.0) * 180.0 / std::numbers::pi;
    scene_ = scene::resolve(assigned(settings, scene), volume->facts);
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = size;
    request.aovs = {render::Aov::hit, render::Aov::position};
    report_ = renderer_->render(scene_, request);
    color_ = renderer_->readLinear();
    hit_ = renderer_->readAov(render::Aov::hit);
    position_ = renderer_->readAov(render::Aov::position);
  }
  double ridge(std::size_t i) const { return color_.rgba[4 * i]; }
  double valley(std::size_t i) const { return color_.rgba[4 * i + 2]; }
  bool hit(std::size_t i) const { return hit_.values[i] == 1.0f; }
  std::size_t pixels() const { return hit_.values.size(); }
  glm::dvec3 fromCentre(std::size_t i) const { return at(position_, i) - centre_; }

  render::LinearImage color_;
  render::AovImage hit_, position_;
  glm::dvec3 centre_{0.0};
};

// The surface y = height(x, z), all from the middle, mm; voxels of 1 mm.
std::shared_ptr<const volume::PreparedVolume> relief(const std::function<double(double, double)>& height,
                                                     glm::ivec3 dims = {64, 24, 64}, double noise = 0.0) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<float> voxels;
  const glm::dvec3 middle = 0.5 * glm::dvec3(dims - 1);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        voxels.push_back(
            static_cast<float>(y - middle.y - height(x - middle.x, z - middle.z) + noise * normal(random)));
  return prepared(volume::Grid(volume::GridGeometry::make(dims, glm::dvec3(1.0)), std::move(voxels)));
}

double wave(double mm) {
  return 3.0 * std::cos(2.0 * std::numbers::pi * mm / 21.0);
}

// What a line that crosses a segment of pixels covers of it, and its middle.
struct Crossing {
  double width = 0.0, moment = 0.0;
  void add(double coverage, double place) {
    width += coverage;
    moment += coverage * place;
  }
  double middle() const { return moment / width; }
};

}  // namespace

// Straight waves: their crests, seen from -y, are 10.5 mm beside the middle; valleys run through it.
TEST_F(LinesGlTest, RidgesAreWholeEvenAndWhereTheyBelong) {
  const auto waves = relief([](double x, double) { return wave(x); });
  struct Case {
    std::vector<std::string> settings;
    double mmPerPixel, pixels;
  };
  for (const Case& c : {Case{{"look.ridge_width=2"}, 0.5, 2.0}, Case{{"look.ridge_width=4"}, 0.5, 4.0},
                        Case{{"look.ridge_width=3"}, 0.25, 3.0}, Case{{"look.ridge_width=3"}, 1.0, 3.0},
                        Case{{"look.ridge_width=1.5", "look.ridge_width_unit=mm"}, 0.25, 6.0}}) {
    draw(waves, c.settings, c.mmPerPixel);
    for (int row = 24; row < 104; ++row) {
      Crossing left, middle, right;
      for (int x = 0; x < 128; ++x) {
        const auto i = static_cast<std::size_t>(row * 128 + x);
        if (!hit(i) || std::fabs(fromCentre(i).z) > 24.0) continue;
        const double place = fromCentre(i).x;
        if (std::fabs(place + 10.5) < 5.0) left.add(ridge(i), place + 10.5);
        if (std::fabs(place) < 5.0) middle.add(valley(i), place);
        if (std::fabs(place - 10.5) < 5.0) right.add(ridge(i), place - 10.5);
      }
      const double atRow = fromCentre(static_cast<std::size_t>(row * 128 + 64)).z;
      if (!(std::fabs(atRow) < 24.0)) continue;  // beside the surface it is no number
      for (const Crossing& line : {left, middle, right}) {
        ASSERT_NEAR(line.width, c.pixels, 0.35) << c.settings[0] << " row " << row;
        ASSERT_NEAR(line.middle(), 0.0, c.mmPerPixel) << c.settings[0] << " row " << row;
      }
    }
  }
}

// Rings around the middle: along a radius the profile is that of a straight wave, most curved at its crest,
// where the slope is 0 and the third derivative too.
TEST_F(LinesGlTest, ARingIsClosedAndWithinAPixelOfItsCrest) {
  draw(relief([](double x, double z) { return wave(std::hypot(x, z)); }), {"look.ridge_width=2"}, 0.5);
  constexpr int sectors = 72;
  std::vector<Crossing> ring(sectors);
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (!hit(i)) continue;
    const glm::dvec3 p = fromCentre(i);
    const double radius = std::hypot(p.x, p.z);
    if (std::fabs(radius - 10.5) > 4.0) continue;
    const double turn = std::atan2(p.z, p.x) / (2.0 * std::numbers::pi) + 0.5;
    ring[std::min(static_cast<std::size_t>(turn * sectors), ring.size() - 1)].add(ridge(i), radius - 10.5);
  }
  const double arc = 2.0 * std::numbers::pi * 10.5 / sectors / 0.5;  // pixels
  for (const Crossing& sector : ring) {
    EXPECT_NEAR(sector.width / arc, 2.0, 0.8);
    EXPECT_NEAR(sector.middle(), 0.0, 0.5);
  }
}

// What noise makes of a flat are specks of every direction: none is as long as a line.
TEST_F(LinesGlTest, ANoisyFlatHasNoLines) {
  const auto flat = relief([](double, double) { return 0.0; }, {64, 24, 64}, 0.05);
  const auto covered = [&](const char* length) {
    draw(flat, {"derivatives.noise=0", "look.ridge_threshold=0.02", length}, 0.5);
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels(); ++i)
      if (hit(i) && std::max(std::fabs(fromCentre(i).x), std::fabs(fromCentre(i).z)) < 24.0)
        sum += ridge(i) + valley(i);
    return sum / static_cast<double>(pixels());
  };
  EXPECT_GT(covered("look.ridge_length=0"), 0.1);
  EXPECT_LT(covered("look.ridge_length=20"), 0.002);
}

// A crest that a dent of a voxel interrupts is one line.
TEST_F(LinesGlTest, ShortGapsAreClosed) {
  const auto interrupted = relief([](double x, double z) {
    return wave(x) + 1.2 * std::exp(-0.5 * (z * z) / 0.64) * std::exp(-0.5 * std::pow((x - 10.5) / 2.0, 2.0));
  });
  draw(interrupted, {"look.ridge_width=2"}, 0.5);
  std::size_t broken = 0;
  for (int row = 44; row < 84; ++row) {
    double width = 0.0;
    for (int x = 0; x < 128; ++x) {
      const auto i = static_cast<std::size_t>(row * 128 + x);
      if (hit(i) && std::fabs(fromCentre(i).x - 10.5) < 4.0) width += ridge(i);
    }
    broken += width < 1.0;
  }
  EXPECT_LE(broken, 2u);
}

}  // namespace isolux::test
