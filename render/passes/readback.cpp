#include "render/passes/readback.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/gl/constants.h"
#include "render/passes/cut_faces_pass.h"
#include "volume/field/reconstruct.h"

namespace isolux::render {

namespace {

std::size_t channelsOf(Aov aov) {
  for (const AovInfo& info : aovs())
    if (info.aov == aov) return info.channels.size();
  return 0;
}

// How far before the eye the ray of a pixel starts, mm along it.
double rayStart(const DrawnFrame& drawn, std::size_t ray) {
  if (drawn.startDepth == 0.0) return drawn.rayStartMm;
  const glm::dvec2 at = glm::dvec2(volume::Extent2{drawn.raySize}.at(ray) + drawn.tileOrigin) + 0.5;
  const glm::dvec2 plane = (at / glm::dvec2(drawn.wholeSize) * 2.0 - 1.0) * drawn.halfExtent;
  return drawn.startDepth * std::sqrt(1.0 + glm::dot(plane, plane));
}

// Diagonal or mixed entries; the processor's are in memory.
std::vector<float> hessianOf(const FrameState& frame, std::size_t which) {
  if (frame.images.has(image::hessian)) return frame.image(image::hessian, which).readFloats(4);
  std::vector<float> values;
  for (const glm::vec4& texel : frame.host.at("").hessian[1 + which].texels)
    values.insert(values.end(), {texel.x, texel.y, texel.z, texel.w});
  return values;
}

glm::dvec3 vectorAt(const std::vector<float>& image, std::size_t pixel) {
  return {image[4 * pixel], image[4 * pixel + 1], image[4 * pixel + 2]};
}

// Outward; 0 where the gradient vanishes.
glm::dvec3 normalAt(const std::vector<float>& gradient, const DrawnFrame& drawn, std::size_t pixel) {
  const glm::dvec3 g = vectorAt(gradient, pixel);
  const double length = glm::length(g);
  return length > 0.0 ? g * (drawn.outward / length) : glm::dvec3(0.0);
}

// Unit, also where the gradient has so few bits that its normal does not stand at right angles to the
// direction; 0 where there is no normal or no direction.
glm::dvec3 directionAcross(glm::dvec3 normal, glm::dvec3 direction) {
  const glm::dvec3 across = glm::cross(normal, direction);
  const double length = glm::length(across);
  return length > 0.0 ? across / length : glm::dvec3(0.0);
}

void put(const glm::dvec3& v, float* out) {
  for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(v[c]);
}

// Writes the channels of a pixel that shows the surface, bottom row first; those that it leaves are NaN.
using PixelReader = std::function<void(std::size_t pixel, float* out)>;

// `surface`: points, of which an AOV may be made, too.
PixelReader readerOf(const FrameState& frame, const DrawnFrame& drawn, Aov aov,
                     const std::vector<float>& surface) {
  const auto floats = [&](const char* name, int channels, std::size_t which = 0) {
    return frame.image(name, which).readFloats(channels);
  };
  switch (aov) {
    case Aov::hit:
      return [](std::size_t, float* out) { out[0] = 1.0f; };
    case Aov::voxel:
      return [&](std::size_t i, float* out) { put(vectorAt(surface, i), out); };
    case Aov::position:
      return [&](std::size_t i, float* out) {
        put(frame.volume->grid().geometry().worldOf(vectorAt(surface, i)), out);
      };
    case Aov::depth:
      return [&](std::size_t i, float* out) {
        out[0] = static_cast<float>(surface[4 * i + 3] + rayStart(drawn, i));
      };
    case Aov::value_error:
      return [&, info = floats(image::surface, 2, 1)](std::size_t i, float* out) {
        out[0] = static_cast<float>(info[2 * i] * std::fabs(frame.volume->dataUnitsPerTexel(drawn.hitField)));
      };
    case Aov::gradient:
      return [of = floats(frame.withHessian ? image::tangents : image::gradient, 4)](
                 std::size_t i, float* out) { put(vectorAt(of, i), out); };
    case Aov::normal:
      return [&, gradient = frame.gradientImage().readFloats(4)](std::size_t i, float* out) {
        if (const glm::dvec3 n = normalAt(gradient, drawn, i); n != glm::dvec3(0.0)) put(n, out);
      };
    case Aov::hessian:
      return [diagonal = hessianOf(frame, 0), mixed = hessianOf(frame, 1)](std::size_t i, float* out) {
        if (diagonal[4 * i + 3] == 0.0f) return;  // not known there
        put(vectorAt(diagonal, i), out);
        put(vectorAt(mixed, i), out + 3);
      };
    case Aov::kappa:
      return
          [of = floats(image::curvature, 4)](std::size_t i, float* out) { std::copy_n(&of[4 * i], 2, out); };
    case Aov::curvature_confidence:
      return [of = floats(image::curvature, 4)](std::size_t i, float* out) { out[0] = of[4 * i + 2]; };
    case Aov::flowline_curvature:
      return [of = floats(image::curvature, 1, 2)](std::size_t i, float* out) { out[0] = of[i]; };
    case Aov::scale:
      return [&](std::size_t, float* out) { out[0] = static_cast<float>(drawn.scaleMm); };
    case Aov::edge_offset:
      return [of = floats(image::edge, 2)](std::size_t i, float* out) {
        if (of[2 * i] < kNoEdge) out[0] = of[2 * i];
      };
    case Aov::edge_strength:
      return [of = floats(image::edge, 2)](std::size_t i, float* out) { out[0] = of[2 * i + 1]; };
    case Aov::color_value:
      return [of = floats(image::second, 4)](std::size_t i, float* out) {
        if (of[4 * i] < kNoValue) out[0] = of[4 * i];
      };
    case Aov::label:
      return [of = floats(image::label, 4)](std::size_t i, float* out) {
        if (of[4 * i + 3] < kNoValue) out[0] = of[4 * i + 3];
      };
    case Aov::piece:
      return [of = floats(image::piece, 1)](std::size_t i, float* out) {
        if (of[i] >= 0.0f) out[0] = of[i];
      };
    case Aov::irradiance:
      return [&, of = floats(image::irradiance, 4)](std::size_t i, float* out) {
        if (drawn.lit) put(vectorAt(of, i), out);
      };
    case Aov::direction1:
      return [of = floats(image::curvature, 4, 1)](std::size_t i, float* out) { put(vectorAt(of, i), out); };
    case Aov::direction2:
      break;
  }
  return [&, gradient = floats(image::tangents, 4), first = floats(image::curvature, 4, 1)](std::size_t i,
                                                                                            float* out) {
    put(directionAcross(normalAt(gradient, drawn, i), vectorAt(first, i)), out);
  };
}

// Puts the top row of an image of four channels first.
template <class Value>
void flip(std::vector<Value>& rgba, glm::ivec2 size) {
  const auto row = static_cast<std::ptrdiff_t>(size.x) * 4;
  for (std::ptrdiff_t y = 0; y < size.y / 2; ++y)
    std::swap_ranges(rgba.begin() + y * row, rgba.begin() + (y + 1) * row,
                     rgba.begin() + (size.y - 1 - y) * row);
}

LinearImage topRowFirst(const Texture& texture, const FrameState* faces = nullptr) {
  LinearImage image{.size = glm::ivec2(texture.size()), .rgba = texture.readFloats(4)};
  if (faces) addCutFaces(*faces, image.rgba);
  flip(image.rgba, image.size);
  return image;
}

}  // namespace

LinearImage readLinear(const FrameState& frame) {
  return topRowFirst(frame.images.at(image::color).images[0], &frame);
}

LinearImage readLinearPicture(const FrameState& frame, const DrawnFrame& drawn) {
  LinearImage picture = topRowFirst(frame.images.at(image::linear).images[0]);
  picture.transparent = drawn.transparentPicture;
  return picture;
}

ColorImage readColor(const FrameState& frame, const DrawnFrame& drawn) {
  const Gl& gl = *frame.gl;
  ColorImage image;
  image.size = drawn.pictureSize;
  image.transparent = drawn.transparentPicture;
  image.rgba.resize(4 * volume::Extent2{image.size}.count());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.GetTextureImage(frame.images.at(image::picture).images[0].id(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     static_cast<GLsizei>(image.rgba.size()), image.rgba.data());
  flip(image.rgba, image.size);
  return image;
}

AovImage readAov(const FrameState& frame, const DrawnFrame& drawn, Aov aov) {
  const glm::ivec2 size = drawn.raySize;
  AovImage image{aov, size, static_cast<int>(channelsOf(aov)), {}};
  const std::vector<float> surface = frame.image(image::surface, 0).readFloats(4);
  const PixelReader read = readerOf(frame, drawn, aov, surface);
  const std::size_t width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
  const std::size_t channels = channelsOf(aov);
  image.values.assign(width * height * channels,
                      aov == Aov::hit ? 0.0f : std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < width * height; ++i)
    if (!(surface[4 * i + 3] < 0.0f))
      read(i, &image.values[((height - 1 - i / width) * width + i % width) * channels]);
  return image;
}

namespace {

struct HitPart {
  glm::ivec2 from, to;  // rays
  glm::ivec2 grid;      // that are read of them, evenly spread
};

std::vector<float> readPart(const FrameState& frame, const Texture& image, const HitPart& part, GLenum format,
                            int channels) {
  if (part.grid == glm::ivec2(image.size())) return image.readFloats(channels);
  const Texture some = Texture::make2D(frame.gl, format, part.grid);
  const Framebuffer from(frame.gl, {&image}), target(frame.gl, {&some});
  frame.gl->BlitNamedFramebuffer(from.id(), target.id(), part.from.x, part.from.y, part.to.x, part.to.y, 0, 0,
                                 part.grid.x, part.grid.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  return some.readFloats(channels);
}

gi::VisiblePointSet hitsOfPart(const FrameState& frame, const HitPart& part, double outward) {
  const Target& surface = frame.images.at(image::surface + frame.layer);
  const std::vector<float> points = readPart(frame, surface.images[0], part, GL_RGBA32F, 4);
  const std::vector<float> info = readPart(frame, surface.images[1], part, GL_RG32F, 2);
  std::vector<std::uint8_t> baked;
  for (const Surface& shown : frame.surfaces) baked.push_back(scene::bakesLight(shown));
  gi::VisiblePointSet hits;
  for (std::size_t i = 0; 4 * i < points.size(); ++i) {
    const float* const point = &points[4 * i];
    if (!(point[3] >= 0.0f)) continue;
    const auto known = volume::HitInfo::of(info[2 * i + 1]);
    if (baked[static_cast<std::size_t>(known.surface())] == 0) continue;
    (known.risesBehind() == (outward < 0.0) ? hits.outer : hits.inner)
        .emplace_back(point[0], point[1], point[2]);
  }
  return hits;
}

void append(std::vector<glm::vec3>& to, const std::vector<glm::vec3>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

void appendHits(const FrameState& frame, std::size_t most, double outward, gi::VisiblePointSet& hits) {
  const glm::ivec2 size(frame.images.at(image::surface + frame.layer).images[0].size());
  glm::ivec2 grid = size;
  for (int step = 1; volume::Extent2{grid}.count() > most;) grid = glm::max(size / ++step, glm::ivec2(1));
  gi::VisiblePointSet found = hitsOfPart(frame, {{0, 0}, size, grid}, outward);
  if (frame.request.hits == FrameRequest::Hits::all && grid != size) {
    found = {};
    const int rows = std::max(1, static_cast<int>(most) / size.x);
    for (int y = 0; y < size.y; y += rows) {
      const int end = std::min(y + rows, size.y);
      const gi::VisiblePointSet more = hitsOfPart(frame, {{0, y}, {size.x, end}, {size.x, end - y}}, outward);
      append(found.outer, more.outer);
      append(found.inner, more.inner);
    }
  }
  append(hits.outer, found.outer);
  append(hits.inner, found.inner);
}

gi::VisiblePointSet hitVoxels(const FrameState& frame, const DrawnFrame& drawn) {
  constexpr std::size_t most = 1u << 20;
  gi::VisiblePointSet hits;
  if (drawn.raySize.x == 0 || !frame.images.has(image::surface)) return hits;
  appendHits(frame, most, drawn.outward, hits);
  const auto reflects = [](const Pass* pass) { return pass->name == pass::reflections; };
  if (std::any_of(frame.used.begin(), frame.used.end(), reflects)) append(hits.outer, frame.reflectedHits);
  if (!drawn.layered) return hits;
  append(hits.outer, frame.hitsBehind.outer);
  append(hits.inner, frame.hitsBehind.inner);
  return hits;
}

}  // namespace isolux::render
