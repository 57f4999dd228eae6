// Cuts in pictures: closed forms of a ball, cut faces against the values of the plane, shadows, what runs.
#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "app/slices/slice_picture.h"
#include "base/color.h"
#include "render/passes/cut_faces_pass.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/surfaces.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {
namespace {

constexpr glm::ivec2 kSize{96, 80};
constexpr double kRadius = 12.0;  // mm

// A ball whose values are 100 less the distance from its middle: the surface at 88 has the radius 12.
volume::GridGeometry slanted() {
  volume::GridGeometry geometry = unitGeometry({48, 44, 30});
  geometry.worldFromVoxel =
      glm::dmat4{{0.8, 0.1, 0, 0}, {0.1, -0.9, 0.1, 0}, {0.1, 0, 1.3, 0}, {-3, 40, -60, 1}};
  return geometry;
}
glm::dvec3 middle() {
  const volume::GridGeometry geometry = slanted();
  return glm::dvec3(geometry.worldFromVoxel * glm::dvec4(0.5 * glm::dvec3(geometry.dims - 1), 1.0));
}
std::shared_ptr<const volume::PreparedVolume> ball() {
  static const auto volume =
      prepared(gridOfWorld(slanted(), [](glm::dvec3 p) { return 100.0 - glm::distance(p, middle()); }));
  return volume;
}

scene::Scene view(glm::dvec3 toward) {
  scene::Scene scene;
  scene.surfaces.front().value = 100.0 - kRadius;
  scene.camera.target = middle();
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.camera.eye = middle() + toward;
  scene.look.mode = scene::LookMode::lambert;
  scene.look.legend = false;
  return scene;
}
const scene::ClipPlane kPlane{middle() + glm::dvec3(0, 0, 3), {0.3, 0.2, 1.0}};

// Along a world ray: where it meets the ball that the plane leaves; or the cut face, as its t.
struct Seen {
  std::optional<double> hit, face;
  bool close = false;  // to an edge of what is seen
};
Seen seenOf(const scene::Ray& ray, bool capped) {
  Seen seen;
  const glm::dvec3 normal = glm::normalize(kPlane.normal), from = ray.origin - middle();
  const double b = glm::dot(from, ray.direction), rest = b * b - glm::dot(from, from) + kRadius * kRadius;
  const double plane = glm::dot(kPlane.point - ray.origin, normal) / glm::dot(ray.direction, normal);
  const bool enters = glm::dot(ray.direction, normal) < 0.0;  // what is kept
  seen.close = std::abs(rest) < 8.0;
  if (rest < 0.0) return seen;
  const double roots[2] = {-b - std::sqrt(rest), -b + std::sqrt(rest)};
  const double begin = enters ? plane : -1e9, end = enters ? 1e9 : plane;
  for (const double root : roots) seen.close = seen.close || std::abs(root - plane) < 0.3;
  if (capped && begin > roots[0] && begin < roots[1]) {
    seen.face = begin;
    return seen;
  }
  for (const double root : roots)
    if (!seen.hit && root >= begin && root <= end) seen.hit = root;
  return seen;
}

// The same with an octant of the ball removed: roots beside it, and where the ray leaves it within the ball.
const glm::dvec3 kCorner{middle() + glm::dvec3(1.0, -0.5, 1.5)};
Seen seenBesideCorner(const scene::Ray& ray, bool capped, bool orthographic = false) {
  Seen seen;
  const glm::dvec3 from = ray.origin - middle();
  const double b = glm::dot(from, ray.direction), rest = b * b - glm::dot(from, from) + kRadius * kRadius;
  seen.close = std::abs(rest) < 8.0;
  if (rest < 0.0) return seen;
  const double roots[2] = {-b - std::sqrt(rest), -b + std::sqrt(rest)};
  glm::dvec3 planes;
  double begin = -1e9, end = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    planes[axis] = (kCorner[axis] - ray.origin[axis]) / ray.direction[axis];
    if (ray.direction[axis] > 0.0)
      begin = std::max(begin, planes[axis]);
    else
      end = std::min(end, planes[axis]);
  }
  for (const double root : roots) {
    const glm::dvec3 at = ray.origin + root * ray.direction - kCorner;
    seen.close = seen.close || std::abs(std::min({at.x, at.y, at.z})) < 0.4;  // its border
  }
  const bool removes = begin < end;
  if (std::abs(begin - end) < 0.6) seen.close = true;  // to an edge of the box
  const bool face = capped && removes && end > roots[0] && end < roots[1];
  for (const double root : roots) {
    if (face && end < root) break;
    const bool before = orthographic || root > 0.0;  // the eye
    if (before && !seen.hit && !(removes && root >= begin && root < end)) seen.hit = root;
  }
  if (face && !seen.hit) seen.face = end;
  return seen;
}

class CutsGlTest : public ExecutorsGlTest {
 protected:
  render::ColorImage colors(scene::Scene scene, int supersampling = 1, bool linear = false) {
    renderer_->setVolume(ball());
    render::FrameRequest request;
    request.size = kSize;
    request.supersampling = supersampling;
    request.linear = linear;
    scene_ = scene::resolve(scene, ball()->facts);
    report_ = renderer_->render(scene_, request);
    return renderer_->readColor();
  }
  bool ran(const char* pass) const {
    return std::any_of(report_.passes.begin(), report_.passes.end(), [&](const render::PassReport& one) {
      return one.name == pass && one.state == render::PassState::ran;
    });
  }
};
ISOLUX_ON_BOTH_EXECUTORS(CutsGlTest);

TEST_P(CutsGlTest, EveryPixelSeesTheBallThatIsLeft) {
  for (const char* setting : {"hit.field=trilinear", "hit.field=cubic_interpolating", "hit.method=sampled",
                              "camera.projection=orthographic"})
    for (const scene::ClipCap cap : {scene::ClipCap::none, scene::ClipCap::inside})
      for (const glm::dvec3& toward :
           {glm::dvec3(5, 9, 50), glm::dvec3(40, 20, 6), glm::dvec3(-10, 5, -50)}) {
        scene::Scene scene = assigned({setting}, view(toward));
        scene.clip.planes = {kPlane};
        scene.clip.cap = cap;
        const Images seen = images(ball(), scene, kSize);
        int hits = 0, compared = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i) {
          const scene::Ray ray = this->ray({i % kSize.x, i / kSize.x}, kSize);
          const Seen expected = seenOf(ray, cap == scene::ClipCap::inside);
          if (expected.close) continue;
          const auto pixel = static_cast<std::size_t>(i);
          ++compared;
          ASSERT_EQ(seen.hit.values[pixel] == 1.0f, expected.hit.has_value())
              << setting << ' ' << static_cast<int>(cap) << ", pixel " << i % kSize.x << ' ' << i / kSize.x;
          if (!expected.hit) continue;
          ++hits;
          ASSERT_LT(glm::distance(at(seen.position, pixel), ray.origin + *expected.hit * ray.direction),
                    0.25);
        }
        EXPECT_GT(compared, 5000) << setting;
        if (cap == scene::ClipCap::none || toward.z < 50.0) {
          EXPECT_GT(hits, 50) << setting;
        }
      }
}

TEST_P(CutsGlTest, EveryPixelSeesTheBallWithoutItsCorner) {
  for (const char* setting : {"hit.field=trilinear", "hit.field=cubic_interpolating", "hit.method=sampled",
                              "camera.projection=orthographic", "clip.planes=0,0,900 0,0,1"})
    for (const scene::ClipCap cap : {scene::ClipCap::none, scene::ClipCap::inside})
      for (const glm::dvec3& toward : {glm::dvec3(25, 30, 40), glm::dvec3(-40, 20, 6), glm::dvec3(6, 5, 7)}) {
        scene::Scene scene = assigned({setting}, view(toward));
        // As one box, and as two that touch.
        const glm::dvec3 far = kCorner + glm::dvec3(1e4), between(kCorner.x + 4.0, kCorner.y, kCorner.z);
        scene.clip.removed = {far, kCorner};
        if (toward.x < 0.0) scene.clip.removed = {kCorner, {between.x, far.y, far.z}, between, far};
        scene.clip.cap = cap;
        const Images seen = images(ball(), scene, kSize);
        int hits = 0, compared = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i) {
          const scene::Ray ray = this->ray({i % kSize.x, i / kSize.x}, kSize);
          const Seen expected = seenBesideCorner(ray, cap == scene::ClipCap::inside,
                                                 scene.camera.projection == scene::Projection::orthographic);
          if (expected.close) continue;
          const auto pixel = static_cast<std::size_t>(i);
          ++compared;
          ASSERT_EQ(seen.hit.values[pixel] == 1.0f, expected.hit.has_value())
              << setting << ' ' << static_cast<int>(cap) << ", pixel " << i % kSize.x << ' ' << i / kSize.x;
          if (!expected.hit) continue;
          ++hits;
          ASSERT_LT(glm::distance(at(seen.position, pixel), ray.origin + *expected.hit * ray.direction),
                    0.25);
        }
        EXPECT_GT(compared, 4000) << setting;
        if (cap == scene::ClipCap::none || toward.x != 6.0) {
          EXPECT_GT(hits, 50) << setting;
        }
      }
}

// Three faces meet in the corner: all pixels between its borders show the values there, without a crack.
TEST_P(CutsGlTest, FacesThatMeetInACornerShowTheirValues) {
  scene::Scene scene = view({25, 30, 40});
  scene.clip.removed = {kCorner, kCorner + glm::dvec3(1e4)};
  scene.slice.level = 94.0;
  scene.slice.width = 10.0;
  scene.look.backgroundTop = scene.look.backgroundBottom = {1.0, 0.0, 0.0};
  const render::ColorImage picture = colors(scene);
  const render::CutFaceColors expectedColors = render::cutFaceColors(scene_, *ball());
  const glm::dmat4 voxelFromWorld = slanted().voxelFromWorld();
  int faces = 0;
  for (int i = 0; i < kSize.x * kSize.y; ++i) {
    const scene::Ray ray = this->ray({i % kSize.x, i / kSize.x}, kSize);
    const Seen seen = seenBesideCorner(ray, true);
    if (seen.close || !seen.face) continue;
    ++faces;
    const glm::dvec3 at = ray.origin + *seen.face * ray.direction;
    const double value =
        volume::sampleTrilinear(ball()->grid(), glm::dvec3(voxelFromWorld * glm::dvec4(at, 1.0))).value;
    const glm::vec3 color = expectedColors.at(static_cast<float>(value));
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(picture.rgba[static_cast<std::size_t>(4 * i + c)],
                  255.0 * base::encodeSrgb(static_cast<double>(color[c])), 1.6)
          << i % kSize.x << ' ' << i / kSize.x;
  }
  EXPECT_GT(faces, 800);
}

// With the plane before the eye's side the face is a disc of the values that trilinear sampling gives there.
TEST_P(CutsGlTest, CutFacesShowTheValuesOfThePlane) {
  scene::Scene scene = view({5, 9, 50});
  scene.clip.planes = {kPlane};
  scene.slice.level = 94.0;
  scene.slice.width = 10.0;
  scene.look.backgroundTop = scene.look.backgroundBottom = {1.0, 0.0, 0.0};
  const render::ColorImage picture = colors(scene);
  EXPECT_FALSE(report_.empty);
  const render::CutFaceColors expectedColors = render::cutFaceColors(scene_, *ball());
  const glm::dmat4 voxelFromWorld = slanted().voxelFromWorld();
  int faces = 0;
  for (int i = 0; i < kSize.x * kSize.y; ++i) {
    const scene::Ray ray = this->ray({i % kSize.x, i / kSize.x}, kSize);
    const Seen seen = seenOf(ray, true);
    if (seen.close || !seen.face) continue;
    ++faces;
    const glm::dvec3 at = ray.origin + *seen.face * ray.direction;
    const double value =
        volume::sampleTrilinear(ball()->grid(), glm::dvec3(voxelFromWorld * glm::dvec4(at, 1.0))).value;
    const glm::vec3 color = expectedColors.at(static_cast<float>(value));
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(picture.rgba[static_cast<std::size_t>(4 * i + c)],
                  255.0 * base::encodeSrgb(static_cast<double>(color[c])), 1.6)
          << i % kSize.x << ' ' << i / kSize.x;
  }
  EXPECT_GT(faces, 800);
}

// Seen along its normal a cut face is the slice of its plane, pixel by pixel: the same values through the
// same level, width and map, in whatever direction the plane lies. In linear light to float rounding; of 255
// steps the picture's dither (half a step) and rounding make one at most, as often up as down.
TEST_P(CutsGlTest, ACutFaceIsTheSliceOfItsPlane) {
  for (const glm::dvec3& normal :
       {glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0), glm::dvec3(0.3, 0.2, 1.0), glm::dvec3(-0.7, 0.6, -0.4)})
    for (const char* setting : {"slice.map=gray", "slice.map=viridis", "slice.field=cubic",
                                "slice.field=cubic_interpolating", "clip.cap=whole"}) {
      scene::Scene scene =
          assigned({"camera.projection=orthographic", setting}, view(60.0 * glm::normalize(normal)));
      scene.camera.up = {0.2, 1.0, -0.1};
      scene.clip.planes = {{middle() + 2.0 * glm::normalize(normal), normal}};
      scene.slice.level = 93.0;
      scene.slice.width = 9.0;
      scene.slice.contourWidth = 0.0;
      const render::ColorImage seen = colors(scene, 1, true);
      const render::LinearImage linear = renderer_->readLinearPicture();
      const render::CutFaceColors expectedColors = render::cutFaceColors(scene_, *ball());
      const scene::CameraFrame frame = scene::frameOf(scene_.camera);
      volume::SlicePlane plane;
      plane.size = kSize;
      const double pixelMm = 2.0 * frame.halfHeight / kSize.y;
      plane.rightMm = pixelMm * frame.right;
      plane.downMm = -pixelMm * frame.up;
      plane.originMm = scene.clip.planes[0].point - 0.5 * (kSize.x - 1) * plane.rightMm -
                       0.5 * (kSize.y - 1) * plane.downMm;
      base::Progress progress;
      const app::SliceContent content = app::sliceContent(*ball(), scene_, plane, progress);
      const render::ColorImage slice =
          app::slicePicture(content, scene_.slice, ball()->grid().geometry(), progress);
      int compared = 0, different = 0, sum = 0;
      for (int i = 0; i < kSize.x * kSize.y; ++i) {
        const auto pixel = static_cast<std::size_t>(i);
        const double fromMiddle = glm::distance(plane.at({i % kSize.x, i / kSize.x}), middle());
        const bool whole = scene_.clip.cap == scene::ClipCap::whole;
        if (whole ? std::isnan(content.values.values[pixel]) : fromMiddle > kRadius - 0.5) continue;
        ++compared;
        const glm::vec3 color = expectedColors.at(content.values.values[pixel]);
        for (std::size_t c = 0; c < 3; ++c) {
          ASSERT_NEAR(linear.rgba[4 * pixel + c], color[static_cast<int>(c)], 1e-5) << setting;
          const int apart = seen.rgba[4 * pixel + c] - slice.rgba[4 * pixel + c];
          different += apart != 0;
          sum += apart;
          ASSERT_LE(std::abs(apart), 1) << setting << ", " << i % kSize.x << ' ' << i / kSize.x;
        }
      }
      EXPECT_GT(compared, 500) << setting;
      EXPECT_LE(different, 0.3 * 3 * compared) << setting;
      EXPECT_NEAR(static_cast<double>(sum) / (3 * compared), 0.0, 0.05) << setting;
    }
}

// Rays within a pixel are averaged: far from edges a face of even slope has the values of pixel centres.
TEST_P(CutsGlTest, SupersamplingAveragesFaces) {
  scene::Scene scene = view({5, 9, 50});
  scene.clip.planes = {kPlane};
  scene.slice.level = 94.0;
  scene.slice.width = 30.0;
  const render::ColorImage one = colors(scene), four = colors(scene, 2);
  ASSERT_EQ(one.rgba.size(), four.rgba.size());
  int inner = 0, softened = 0;
  for (int i = 0; i < kSize.x * kSize.y; ++i) {
    const Seen seen = seenOf(this->ray({i % kSize.x, i / kSize.x}, kSize), true);
    const auto pixel = static_cast<std::size_t>(4 * i);
    if (seen.close) {
      softened += std::abs(one.rgba[pixel] - four.rgba[pixel]) > 8;
    } else if (seen.face) {
      ++inner;
      ASSERT_NEAR(one.rgba[pixel], four.rgba[pixel], 2) << i % kSize.x << ' ' << i / kSize.x;
    }
  }
  EXPECT_GT(inner, 800);
  EXPECT_GT(softened, 20);  // the border of the face is antialiased
}

// Level, width and map change how values look and nothing else; without cuts nothing of it is there.
TEST_P(CutsGlTest, OnlyWhatIsAskedForRuns) {
  scene::Scene scene = view({5, 9, 50});
  colors(scene);
  EXPECT_FALSE(ran("cut faces"));
  scene.slice.level = 90.0;
  scene.clip.cap = scene::ClipCap::whole;
  scene.surfaces.front().clipped = false;
  colors(scene);
  for (const render::PassReport& pass : report_.passes)
    EXPECT_NE(pass.state, render::PassState::ran) << pass.name;
  scene.surfaces.front().clipped = true;
  scene.clip.planes = {kPlane};
  colors(scene);
  EXPECT_TRUE(ran("cut faces"));
  EXPECT_TRUE(ran("cast"));
  scene.slice.width = 3.0;
  colors(scene);
  EXPECT_FALSE(ran("cut faces"));
  EXPECT_FALSE(ran("cast"));
  EXPECT_TRUE(ran("resolve"));
  scene.clip.cap = scene::ClipCap::none;
  const auto open = colors(scene).rgba;
  EXPECT_FALSE(ran("cut faces"));
  scene.clip.cap = scene::ClipCap::whole;
  const auto faces = colors(scene).rgba;
  EXPECT_NE(open, faces);
  scene.clip.cap = scene::ClipCap::none;
  EXPECT_EQ(colors(scene).rgba, open);
  scene.clip.planes.clear();
  EXPECT_NE(colors(scene).rgba, open);
}

// A whole face is there where no surface is at all.
TEST_P(CutsGlTest, WholeFacesNeedNoSurface) {
  scene::Scene scene = view({5, 9, 50});
  scene.surfaces.front().value = 1000.0;
  scene.clip.planes = {kPlane};
  scene.clip.cap = scene::ClipCap::whole;
  scene.look.backgroundTop = scene.look.backgroundBottom = {1.0, 0.0, 0.0};
  const render::ColorImage picture = colors(scene);
  EXPECT_FALSE(report_.empty);
  const auto* middlePixel =
      &picture.rgba[static_cast<std::size_t>(4 * (kSize.y / 2 * kSize.x + kSize.x / 2))];
  EXPECT_EQ(middlePixel[0], middlePixel[1]);  // grey
  EXPECT_GT(middlePixel[1], 100);
}

// A transparent surface that is not cut lies before the face; one that is cut ends at it.
TEST_P(CutsGlTest, TransparentSurfacesLieBeforeTheFace) {
  scene::Scene scene = view({0, 0, 50});
  scene.clip.planes = {{middle(), {0, 0, 1}}};
  scene.surfaces.front().albedo = {0.0, 0.0, 0.0};
  test::surfaceAt(scene, 1) = {.id = "second",
                               .shown = true,
                               .value = 85.0,
                               .albedo = glm::dvec3(0.0),
                               .opacity = 0.5,
                               .clipped = false};
  scene.slice.level = 0.0;
  scene.slice.width = 1.0;  // the face is white
  const std::size_t pixel = static_cast<std::size_t>(4 * (kSize.y / 2 * kSize.x + kSize.x / 2));
  const auto value = [&] { return base::decodeSrgb(colors(scene).rgba[pixel] / 255.0); };
  EXPECT_NEAR(value(), 0.5, 0.01);
  test::surfaceAt(scene, 1).clipped = true;
  EXPECT_NEAR(value(), 1.0, 0.01);
}

// What is cut away throws no shadow: a ball over a plate, with the ball above the plane, or in the box, gone.
TEST_P(CutsGlTest, WhatIsCutAwayThrowsNoShadow) {
  const auto plate = prepared(gridOfVoxels(unitGeometry({40, 40, 40}), [](glm::dvec3 p) {
    return std::max(8.0 - p.z, 7.0 - glm::distance(p, glm::dvec3(19.5, 19.5, 26.0)));
  }));
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.camera.eye = {19.5, -40.0, 60.0};
  scene.camera.target = {19.5, 19.5, 8.0};
  scene.camera.up = {0, 0, 1};
  scene.look.mode = scene::LookMode::lambert;
  scene.look.shadow = 1.0;
  scene.light.space = scene::LightSpace::world;
  scene.light.direction = {0, 0, 1};
  const auto picture = [&] {
    renderer_->setVolume(plate);
    render::FrameRequest request;
    request.size = kSize;
    renderer_->render(scene::resolve(scene, plate->facts), request);
    return renderer_->readColor();
  };
  const auto whole = picture();
  scene.clip.removed = {{0, 0, 15}, {99, 99, 99}};  // the ball is gone
  const auto removed = picture();
  scene.clip.removed.clear();
  scene.clip.planes = {{{0, 0, 15}, {0, 0, 1}}};  // in the same way
  const auto cut = picture();
  EXPECT_EQ(removed.rgba, cut.rgba);
  const auto flat =
      prepared(gridOfVoxels(unitGeometry({40, 40, 40}), [](glm::dvec3 p) { return 8.0 - p.z; }));
  renderer_->setVolume(flat);
  scene.clip.planes.clear();
  render::FrameRequest request;
  request.size = kSize;
  renderer_->render(scene::resolve(scene, flat->facts), request);
  const auto expected = renderer_->readColor();
  int different = 0, shadowed = 0;
  for (std::size_t i = 0; i < cut.rgba.size(); ++i) {
    different += std::abs(static_cast<int>(cut.rgba[i]) - static_cast<int>(expected.rgba[i])) > 2;
    shadowed += std::abs(static_cast<int>(whole.rgba[i]) - static_cast<int>(expected.rgba[i])) > 40;
  }
  EXPECT_LE(different, 8);
  EXPECT_GT(shadowed, 300);
}

}  // namespace
}  // namespace isolux::test
