#include "render/passes/readback.h"

#include <algorithm>
#include <array>
#include <cmath>
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

// The images that an AOV is made from, as floats, bottom row first.
struct Source {
  std::vector<float> surface, info, gradient, first, second;
};

// Diagonal or mixed entries; the processor's are in memory.
std::vector<float> hessianOf(const FrameState& frame, std::size_t which) {
  if (frame.images.has(image::hessian)) return frame.image(image::hessian, which).readFloats(4);
  std::vector<float> values;
  for (const glm::vec4& texel : frame.host.at("").hessian[1 + which].texels)
    values.insert(values.end(), {texel.x, texel.y, texel.z, texel.w});
  return values;
}

Source sourceOf(const FrameState& frame, Aov aov) {
  Source source;
  source.surface = frame.image(image::surface, 0).readFloats(4);
  switch (aov) {
    case Aov::value_error:
      source.info = frame.image(image::surface, 1).readFloats(2);
      break;
    case Aov::normal:
      source.gradient = frame.gradientImage().readFloats(4);
      break;
    case Aov::gradient:
      source.gradient = frame.image(frame.withHessian ? image::tangents : image::gradient).readFloats(4);
      break;
    case Aov::hessian:
      source.first = hessianOf(frame, 0);
      source.second = hessianOf(frame, 1);
      break;
    case Aov::kappa:
    case Aov::curvature_confidence:
      source.first = frame.image(image::curvature, 0).readFloats(4);
      break;
    case Aov::flowline_curvature:
      source.info = frame.image(image::curvature, 2).readFloats(1);
      break;
    case Aov::direction1:
      source.second = frame.image(image::curvature, 1).readFloats(4);
      break;
    case Aov::direction2:
      source.gradient = frame.image(image::tangents).readFloats(4);
      source.second = frame.image(image::curvature, 1).readFloats(4);
      break;
    case Aov::edge_offset:
    case Aov::edge_strength:
      source.info = frame.image(image::edge).readFloats(2);
      break;
    case Aov::color_value:
      source.first = frame.image(image::second).readFloats(4);
      break;
    case Aov::piece:
      source.info = frame.image(image::piece).readFloats(1);
      break;
    case Aov::irradiance:
      source.first = frame.image(image::irradiance).readFloats(4);
      break;
    case Aov::hit:
    case Aov::voxel:
    case Aov::position:
    case Aov::depth:
    case Aov::scale:
      break;
  }
  return source;
}

glm::dvec3 vectorAt(const std::vector<float>& image, std::size_t pixel) {
  return {image[4 * pixel], image[4 * pixel + 1], image[4 * pixel + 2]};
}

// Outward; 0 where the gradient vanishes.
glm::dvec3 normalAt(const Source& source, const DrawnFrame& drawn, std::size_t pixel) {
  const glm::dvec3 g = vectorAt(source.gradient, pixel);
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

LinearImage topRowFirst(const Texture& texture, const FrameState* faces = nullptr) {
  const glm::ivec2 size(texture.size());
  LinearImage image{.size = size, .rgba = texture.readFloats(4)};
  if (faces) addCutFaces(*faces, image.rgba);
  const auto row = static_cast<std::ptrdiff_t>(size.x) * 4;
  for (std::ptrdiff_t y = 0; y < size.y / 2; ++y)
    std::swap_ranges(image.rgba.begin() + y * row, image.rgba.begin() + (y + 1) * row,
                     image.rgba.begin() + (size.y - 1 - y) * row);
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
  const std::size_t row = static_cast<std::size_t>(image.size.x) * 4;
  std::vector<std::uint8_t> flipped(row * static_cast<std::size_t>(image.size.y));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.GetTextureImage(frame.images.at(image::picture).images[0].id(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     static_cast<GLsizei>(flipped.size()), flipped.data());
  image.rgba.resize(flipped.size());
  for (int y = 0; y < image.size.y; ++y)
    std::copy_n(
        flipped.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(image.size.y - 1 - y)),
        row, image.rgba.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y)));
  return image;
}

AovImage readAov(const FrameState& frame, const DrawnFrame& drawn, Aov aov) {
  const glm::ivec2 size = drawn.raySize;
  AovImage image{aov, size, static_cast<int>(channelsOf(aov)), {}};
  const Source source = sourceOf(frame, aov);
  const std::size_t width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
  const std::size_t channels = channelsOf(aov);
  image.values.assign(width * height * channels,
                      aov == Aov::hit ? 0.0f : std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < width * height; ++i) {
    const float* s = &source.surface[4 * i];
    if (s[3] < 0.0f) continue;
    float* out = &image.values[((height - 1 - i / width) * width + i % width) * channels];
    const auto put = [&](const glm::dvec3& v, int from = 0) {
      for (int c = 0; c < 3; ++c) out[from + c] = static_cast<float>(v[c]);
    };
    switch (aov) {
      case Aov::hit:
        out[0] = 1.0f;
        break;
      case Aov::voxel:
        put({s[0], s[1], s[2]});
        break;
      case Aov::position:
        put(frame.volume->grid().geometry().worldOf({s[0], s[1], s[2]}));
        break;
      case Aov::depth:
        out[0] = static_cast<float>(s[3] + rayStart(drawn, i));
        break;
      case Aov::value_error:
        out[0] = static_cast<float>(source.info[2 * i] *
                                    std::fabs(frame.volume->dataUnitsPerTexel(drawn.hitField)));
        break;
      case Aov::gradient:
        put(vectorAt(source.gradient, i));
        break;
      case Aov::normal:
        if (const glm::dvec3 n = normalAt(source, drawn, i); n != glm::dvec3(0.0)) put(n);
        break;
      case Aov::hessian:
        if (source.first[4 * i + 3] == 0.0f) break;  // not known there
        put(vectorAt(source.first, i));
        put(vectorAt(source.second, i), 3);
        break;
      case Aov::kappa:
        for (std::size_t c = 0; c < 2; ++c) out[c] = source.first[4 * i + c];
        break;
      case Aov::curvature_confidence:
        out[0] = source.first[4 * i + 2];
        break;
      case Aov::flowline_curvature:
        out[0] = source.info[i];
        break;
      case Aov::scale:
        out[0] = static_cast<float>(drawn.scaleMm);
        break;
      case Aov::edge_offset:
        if (source.info[2 * i] < kNoEdge) out[0] = source.info[2 * i];
        break;
      case Aov::edge_strength:
        out[0] = source.info[2 * i + 1];
        break;
      case Aov::color_value:
        if (source.first[4 * i] < kNoValue) out[0] = source.first[4 * i];
        break;
      case Aov::piece:
        if (source.info[i] >= 0.0f) out[0] = source.info[i];
        break;
      case Aov::irradiance:
        if (drawn.lit) put(vectorAt(source.first, i));
        break;
      case Aov::direction1:
        put(vectorAt(source.second, i));
        break;
      case Aov::direction2:
        put(directionAcross(normalAt(source, drawn, i), vectorAt(source.second, i)));
        break;
    }
  }
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
  std::array<std::uint8_t, 4> baked{};
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i) baked[i] = scene::bakesLight(frame.surfaces[i]);
  gi::VisiblePointSet hits;
  for (std::size_t i = 0; 4 * i < points.size(); ++i) {
    const float* const point = &points[4 * i];
    if (!(point[3] >= 0.0f)) continue;
    const int known = static_cast<int>(info[2 * i + 1]);  // as surface.glsl reads it
    if (baked[static_cast<std::size_t>(known & 3)] == 0) continue;
    const bool risesBehind = (known >> 2 >> (known & 3) & 1) != 0;
    (risesBehind == (outward < 0.0) ? hits.outer : hits.inner).emplace_back(point[0], point[1], point[2]);
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
