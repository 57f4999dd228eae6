#include "render/passes/legend_overlay.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>

#include <glm/common.hpp>

#include "base/number_text.h"
#include "render/legend/legend.h"
#include "scene/color_maps.h"
#include "scene/curvature_map.h"
#include "scene/looks.h"
#include "scene/rules/needs.h"

namespace isolux::render {

Legend measureLegend(const scene::Scene& scene, glm::dvec2 range) {
  const scene::Look& look = scene.look;
  const scene::LookInfo& info = scene::lookInfo(look.mode);
  Legend legend;
  legend.quantity = info.quantity;
  legend.quantityVertical = info.quantityVertical;
  legend.unit = scene::unitOf(info);
  legend.low = range.x;
  legend.high = range.y;
  if (info.readsEdge) legend.note = "grey: no edge found";
  const double scale = scene::derivativesScale(scene);
  if (scale > 0.0 && !info.readsEdge) legend.note = "scale " + base::shortText(scale, 2) + " mm";
  legend.colors = measureColors(look).texels;
  return legend;
}

namespace {

// Of the second volume, which may not have been read yet.
Legend expectedSecondLegend(const scene::Scene& scene, glm::dvec2 range) {
  Legend legend;
  legend.quantity = std::filesystem::path(scene.color.volume).filename().string();
  legend.unit = "HU";  // about as wide as any
  legend.low = range.x;
  legend.high = range.y;
  legend.note = scene.color.below > 0.0 ? "largest within 0.00 mm" : "";
  legend.colors = {glm::vec3(0.0F), glm::vec3(1.0F)};
  return legend;
}

// Those that make the widest numbers, for ends that are automatic.
std::array<glm::dvec2, 3> widestRanges(const scene::Look& look) {
  std::array<glm::dvec2, 3> ranges{glm::dvec2(-0.0102, 0.0102), {-9e-5, 9e-5}, {-9e4, 9e4}};
  const scene::LookInfo& info = scene::lookInfo(look.mode);
  for (glm::dvec2& range : ranges) {
    if (info.range == scene::LookRange::unit) range = {-1.0, 1.0};
    if (info.range == scene::LookRange::fromZero) range.x = 0.0;
    if (look.rangeLow) range.x = *look.rangeLow;
    if (look.rangeHigh) range.y = *look.rangeHigh;
  }
  return ranges;
}

}  // namespace

glm::ivec2 legendReserve(const scene::Scene& scene, glm::ivec2 picture) {
  if (!scene::showsLegend(scene)) return glm::ivec2(0);
  glm::ivec2 most(0);
  for (const glm::dvec2& range : widestRanges(scene.look)) {
    const bool measure = scene::isMeasure(scene.look.mode);
    Legend legend = measure ? measureLegend(scene, range) : expectedSecondLegend(scene, range);
    if (measure && legend.note.empty() && !scene.derivatives.scale) legend.note = "scale 0.00 mm";
    most = glm::max(most, legendSizeFor(legend, picture));
  }
  return most;
}

namespace {

int marginOf(glm::ivec2 picture) {
  return std::max(2, picture.y / 50);
}

glm::ivec2 placeIn(scene::LegendCorner corner, glm::ivec2 legend, glm::ivec2 picture) {
  using enum scene::LegendCorner;
  const int margin = marginOf(picture);
  const glm::ivec2 far = picture - legend - margin;
  return {corner == lower_left || corner == upper_left ? margin : far.x,
          corner == upper_left || corner == upper_right ? far.y : margin};
}

std::int64_t pixelsIn(const volume::Rectangle& rectangle) {
  return std::int64_t{rectangle.size.x} * rectangle.size.y;
}

}  // namespace

glm::ivec2 legendPlace(scene::LegendCorner corner, glm::ivec2 legend, glm::ivec2 picture,
                       const CoveredPixels& covered) {
  using enum scene::LegendCorner;
  if (corner != automatic) return placeIn(corner, legend, picture);
  const std::int64_t little = pixelsIn({glm::ivec2(0), legend}) / 50;
  scene::LegendCorner best = lower_right;
  std::int64_t least = 0;
  for (const scene::LegendCorner tried : {lower_right, lower_left, upper_right, upper_left}) {
    const std::int64_t pixels = covered({placeIn(tried, legend, picture), legend});
    if (tried != lower_right && pixels + little >= least) continue;
    best = tried;
    least = pixels;
  }
  return placeIn(best, legend, picture);
}

MeasureColors measureColors(const scene::Look& look) {
  constexpr int samples = 256, side = 64;
  const scene::LookInfo& info = scene::lookInfo(look.mode);
  if (info.kind == scene::LookKind::square) return {glm::ivec2(side), scene::curvatureTexels(look, side)};
  if (look.colormapPoints)
    return {glm::ivec2(samples, 1), scene::pointSamples(*look.colormapPoints, samples)};
  return {glm::ivec2(samples, 1), scene::colorMapSamples(look.colormap, samples, info.colors)};
}

namespace {

// Counted in the picture itself: where shaders cast, surfacePixels() are those of rays that may hit
// something, and the legend would stand elsewhere than where the processor casts.
std::int64_t coveredPixels(FrameState& frame, const Target& picture, const volume::Rectangle& part) {
  const bool faces = frame.cutFaceColors != nullptr;
  Program& p = frame.program("covered.frag.glsl", faces ? "#define CUT_FACES\n" : "");
  p.setTexture("uColor", 0, frame.image(image::color));
  if (faces) p.setTexture("uCutFaces", 1, frame.images.at(image::cutFaces).images[0]);
  p.set("uSupersampling", frame.request.supersampling);
  p.set("uColorLow", frame.raysLow());
  frame.begin(picture, frame.drawnSize());
  return frame.samplesOf([&] { frame.drawRectangles(p, {part}); });
}

// Into the part of `picture` that starts at `corner` and may reach beyond it.
void blendByShader(FrameState& frame, const Target& picture, const LegendImage& image, glm::ivec2 corner) {
  const Gl& gl = *frame.gl;
  const Texture texture = Texture::make2D(frame.gl, GL_RGBA8, image.size);
  texture.write(GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  Program& p = frame.program("legend.frag.glsl");
  p.setTexture("uLegend", 0, texture);
  p.set("uCorner", corner);
  gl.BindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer.id());
  gl.Viewport(corner.x, corner.y, image.size.x, image.size.y);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  frame.drawFullscreen(p);
  gl.Disable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ZERO);
}

// The same where alpha is straight, which blending by OpenGL does not know.
void blendStraight(const FrameState& frame, const Target& picture, const LegendImage& image,
                   glm::ivec2 corner) {
  const volume::Rectangle part =
      volume::common({glm::ivec2(0), frame.drawnSize()}, volume::Rectangle{corner, image.size});
  std::vector<float> pixels = picture.images[0].readFloats(4, part);
  for (std::size_t i = 0; i < pixels.size() / 4; ++i) {
    const glm::ivec2 at = part.low - corner + volume::Extent2{part.size}.at(i);
    const std::size_t from = 4 * volume::Extent2{image.size}.index(at.x, image.size.y - 1 - at.y);
    const auto over = [&](std::size_t channel) {
      return static_cast<float>(image.rgba[from + channel]) / 255.0f;
    };
    float* const pixel = &pixels[4 * i];
    const float below = pixel[3] * (1.0f - over(3)), alpha = over(3) + below;
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = alpha > 0.0f ? (over(c) + pixel[c] * below) / alpha : 0.0f;
    pixel[3] = alpha;
  }
  picture.images[0].write(GL_RGBA, GL_FLOAT, pixels.data(), part);
}

}  // namespace

std::optional<Tile> drawLegendOver(FrameState& frame, const Target& picture, const Legend& legend) {
  const glm::ivec2 size = frame.request.size;
  const LegendImage image = legendFor(legend, size);
  if (image.size.x == 0) return {};
  const scene::LegendCorner wanted = frame.scene->look.legendCorner;
  const bool unknown = frame.request.tile.has_value() && wanted == scene::LegendCorner::automatic;
  const Tile place{
      legendPlace(unknown ? scene::LegendCorner::lower_right : wanted, image.size, size,
                  [&](const volume::Rectangle& part) { return coveredPixels(frame, picture, part); }),
      image.size};
  const glm::ivec2 corner = place.origin - frame.tileOrigin();
  const glm::ivec2 drawn = frame.drawnSize();
  if (corner.x >= drawn.x || corner.y >= drawn.y || corner.x + image.size.x <= 0 ||
      corner.y + image.size.y <= 0)
    return place;
  if (frame.scene->picture.transparent)
    blendStraight(frame, picture, image, corner);
  else
    blendByShader(frame, picture, image, corner);
  return place;
}

}  // namespace isolux::render
