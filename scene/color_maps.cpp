#include "scene/color_maps.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "base/color.h"

namespace isolux::scene {

namespace {

using Hex = std::uint32_t;  // 0xrrggbb, sRGB

// Every eighth colour of the published 256 and the last; joined linearly they stay within 2/255 (inferno,
// viridis) and 6/255 (cividis, at its one kink) of the published tables.
constexpr std::array<Hex, 33> viridis = {0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453681, 0x424086,
                                         0x3f4989, 0x3b528b, 0x375a8d, 0x33638d, 0x2f6a8e, 0x2c728e, 0x297a8e,
                                         0x26818e, 0x23898e, 0x21908c, 0x1f988b, 0x1f9f88, 0x21a685, 0x28ae80,
                                         0x31b57b, 0x3ebc74, 0x4cc26c, 0x5dc963, 0x6ece58, 0x82d34c, 0x96d83f,
                                         0xabdc32, 0xc0df24, 0xd5e21a, 0xeae51a, 0xfde725};
constexpr std::array<Hex, 33> cividis = {0x00224e, 0x00285b, 0x002e6a, 0x043371, 0x1a386f, 0x273e6e, 0x32436d,
                                         0x3b496c, 0x434e6c, 0x4b546c, 0x52596d, 0x5a5f6e, 0x61656f, 0x686a71,
                                         0x6f7073, 0x757676, 0x7c7b78, 0x848179, 0x8b8778, 0x938d78, 0x9b9376,
                                         0xa39a75, 0xaba072, 0xb3a670, 0xbbad6c, 0xc3b469, 0xccba64, 0xd4c15f,
                                         0xddc958, 0xe6d051, 0xefd748, 0xf8df3c, 0xfee838};
constexpr std::array<Hex, 33> inferno = {0x000004, 0x040312, 0x0b0724, 0x150b37, 0x210c4a, 0x2e0a5a, 0x3c0965,
                                         0x4a0c6b, 0x57106d, 0x63146e, 0x70196e, 0x7d1e6d, 0x89226a, 0x962766,
                                         0xa32b61, 0xaf315c, 0xbb3755, 0xc63e4d, 0xd14644, 0xdb4f3b, 0xe35932,
                                         0xeb6528, 0xf1711e, 0xf67f14, 0xf98d0a, 0xfb9c06, 0xfcab0f, 0xfbba1f,
                                         0xf9ca32, 0xf5d949, 0xf2e865, 0xf3f586, 0xfcffa4};
constexpr std::array<Hex, 11> spectral = {0x5e4fa2, 0x3288bd, 0x66c2a5, 0xabdda4, 0xe6f598, 0xffffbf,
                                          0xfee08b, 0xfdae61, 0xf46d43, 0xd53e4f, 0x9e0142};
// Cup, trough, rut, saddle rut, saddle, saddle ridge, ridge, dome, cap.
constexpr std::array<Hex, 9> shapeIndex = {0x1b8a4b, 0x2bb3a3, 0x3f7fd0, 0xa9c6ea, 0xf2f0ea,
                                           0xf3e6a2, 0xf0c63c, 0xee8a2e, 0xcc2f2a};

// Between table colours, joined in sRGB as their authors do.
glm::dvec3 fromTable(std::span<const Hex> table, double t) {
  const auto color = [&](std::size_t i) {
    return glm::dvec3((table[i] >> 16) & 255u, (table[i] >> 8) & 255u, table[i] & 255u) / 255.0;
  };
  const double x = t * static_cast<double>(table.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), table.size() - 2);
  const glm::dvec3 srgb = glm::mix(color(i), color(i + 1), x - static_cast<double>(i));
  return {base::decodeSrgb(srgb.x), base::decodeSrgb(srgb.y), base::decodeSrgb(srgb.z)};
}

// CIE L*a*b* (D65 white of sRGB) to linear RGB.
glm::dvec3 linearOfLab(const glm::dvec3& lab) {
  const auto inverse = [](double f) { return f > 6.0 / 29.0 ? f * f * f : (f - 4.0 / 29.0) * 108.0 / 841.0; };
  const double fy = (lab.x + 16.0) / 116.0;
  const glm::dvec3 xyz = glm::dvec3(0.95047, 1.0, 1.08883) *
                         glm::dvec3(inverse(fy + lab.y / 500.0), inverse(fy), inverse(fy - lab.z / 200.0));
  const glm::dmat3 rows(glm::dvec3(3.2404542, -1.5371385, -0.4985314),
                        glm::dvec3(-0.9692660, 1.8760108, 0.0415560),
                        glm::dvec3(0.0556434, -0.2040259, 1.0572252));
  return glm::transpose(rows) * xyz;
}

// Moreland 2009 in his Msh coordinates: magnitude, saturation angle and hue angle of L*a*b* around black.
// Both ends share M and s and so their lightness; the middle is a light grey of M = 88; where saturation
// falls while M grows, hue is turned so that the path keeps its perceived hue.
struct Diverging {
  double magnitude, saturation, lowHue, highHue;  // CIELAB units, radians
};
constexpr Diverging coolwarm{80.0, 1.08, -1.1, 0.5};  // the paper's own example
constexpr Diverging blueOrange{82.0, 0.86, -1.18, 1.15};
constexpr Diverging purpleGreen{74.0, 0.82, -0.72, 2.45};

glm::dvec3 fromDiverging(const Diverging& map, double t) {
  constexpr double middle = 88.0;
  const double side = std::fabs(2.0 * t - 1.0);  // 0 in the middle, 1 at the ends
  const double hue = t < 0.5 ? map.lowHue : map.highHue;
  // The grey has no hue: it gets one turned away from the saturated end's (AdjustHue in the paper).
  const double spin = map.saturation * std::sqrt(middle * middle - map.magnitude * map.magnitude) /
                      (map.magnitude * std::sin(map.saturation));
  const double h = hue + (hue > -std::numbers::pi / 3.0 ? spin : -spin) * (1.0 - side);
  const double m = glm::mix(middle, map.magnitude, side), s = map.saturation * side;
  return linearOfLab(m * glm::dvec3(std::cos(s), std::sin(s) * std::cos(h), std::sin(s) * std::sin(h)));
}

glm::dvec3 fromAutomatic(LookColors colors, double t) {
  if (colors == LookColors::diverging) return fromDiverging(coolwarm, t);
  return fromTable(colors == LookColors::shape ? std::span<const Hex>(shapeIndex) : viridis, t);
}

glm::dvec3 colorOf(ColorMap map, LookColors automatic, double t) {
  switch (map) {
    case ColorMap::automatic:
      return fromAutomatic(automatic, t);
    case ColorMap::viridis:
      return fromTable(viridis, t);
    case ColorMap::cividis:
      return fromTable(cividis, t);
    case ColorMap::inferno:
      return fromTable(inferno, t);
    case ColorMap::gray:
      return linearOfLab({100.0 * t, 0.0, 0.0});
    case ColorMap::coolwarm:
      return fromDiverging(coolwarm, t);
    case ColorMap::blue_orange:
      return fromDiverging(blueOrange, t);
    case ColorMap::purple_green:
      return fromDiverging(purpleGreen, t);
    case ColorMap::spectral:
      return fromTable(spectral, t);
  }
  return glm::dvec3(0.0);
}

}  // namespace

std::vector<glm::vec3> colorMapSamples(ColorMap map, int size, LookColors automatic) {
  assert(size >= 2);
  std::vector<glm::vec3> samples;
  samples.reserve(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i)
    samples.emplace_back(glm::clamp(colorOf(map, automatic, static_cast<double>(i) / (size - 1)), 0.0, 1.0));
  return samples;
}

glm::dvec3 colorOfPoints(std::span<const ColorPoint> points, double t) {
  const auto above = std::ranges::upper_bound(points, t, {}, &ColorPoint::position);
  if (above == points.begin()) return above->color;
  const ColorPoint& below = *(above - 1);
  if (above == points.end()) return below.color;
  return glm::mix(below.color, above->color, (t - below.position) / (above->position - below.position));
}

std::vector<glm::vec3> pointSamples(std::span<const ColorPoint> points, int size) {
  assert(size >= 2);
  std::vector<glm::vec3> samples;
  for (int i = 0; i < size; ++i)
    samples.emplace_back(colorOfPoints(points, static_cast<double>(i) / (size - 1)));
  return samples;
}

std::vector<ColorPoint> automaticColorPoints(const Look& look) {
  constexpr int count = 9;
  const std::vector<glm::vec3> samples = colorMapSamples(look.colormap, count, lookInfo(look.mode).colors);
  std::vector<ColorPoint> points;
  for (std::size_t i = 0; i < samples.size(); ++i)  // to a thousandth: they are read and edited by people
    points.push_back(
        {static_cast<double>(i) / (count - 1), glm::round(glm::dvec3(samples[i]) * 1000.0) / 1000.0});
  return points;
}

std::vector<ColorPoint> automaticAccessibilityPoints() {
  return {{0.0, {0.10, 0.075, 0.06}}, {1.0, glm::dvec3(1.0)}};
}

}  // namespace isolux::scene
