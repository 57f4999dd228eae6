#include "scene/curvature_map.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isolux::scene {

namespace {

constexpr double lightness = 0.72, mostChroma = 0.17;

// Ottosson, "A perceptual color space for image processing", 2020. To linear BT.709; may leave [0, 1].
glm::dvec3 fromOklab(glm::dvec3 lab) {
  const double l = std::pow(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z, 3.0);
  const double m = std::pow(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z, 3.0);
  const double s = std::pow(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z, 3.0);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

glm::dvec3 ofHue(double degrees, double chroma) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return fromOklab({lightness, chroma * std::cos(angle), chroma * std::sin(angle)});
}

bool isShown(const glm::dvec3& color) {
  return glm::clamp(color, 0.0, 1.0) == color;
}

// As saturated as screens show this hue, up to mostChroma.
double chromaOf(double degrees) {
  double low = 0.0, high = mostChroma;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (isShown(ofHue(degrees, middle)) ? low : high) = middle;
  }
  return low;
}

}  // namespace

glm::dvec3 automaticCurvatureColor(glm::dvec2 kappa) {
  kappa = glm::clamp(kappa, -1.0, 1.0);
  const double shape =
      std::atan2(kappa.x + kappa.y, std::fabs(kappa.x - kappa.y)) * 2.0 / std::numbers::pi;  // -1 cup, 1 cap
  const double hue = 162.5 - 137.5 * shape;
  // Most of a surface is curved far less than its strongest places: colour comes soon.
  const double saturation = 1.0 - std::exp(-5.0 * std::min(glm::length(kappa), 1.0));
  return glm::clamp(ofHue(hue, saturation * chromaOf(hue)), 0.0, 1.0);
}

std::vector<CurvaturePoint> automaticCurvaturePoints() {
  constexpr glm::dvec2 shapes[] = {{1, 1},    {1, 0.5}, {1, 0},     {1, -0.5}, {1, -1},
                                   {0.5, -1}, {0, -1},  {-0.5, -1}, {-1, -1}};
  std::vector<CurvaturePoint> points = {{0.0, 0.0, automaticCurvatureColor({0.0, 0.0})}};
  for (const double part : {0.4, 1.0})
    for (const glm::dvec2& shape : shapes)
      points.push_back({part * shape.x, part * shape.y, automaticCurvatureColor(part * shape)});
  return points;
}

glm::dvec3 curvatureColor(std::span<const CurvaturePoint> points, glm::dvec2 kappa) {
  assert(!points.empty());
  constexpr double coincident = 1e-12;  // squared distance, far below a texel's
  kappa = glm::clamp(kappa, -1.0, 1.0);
  glm::dvec3 sum{0.0}, exact{0.0};
  double weights = 0.0;
  int hits = 0;
  for (const CurvaturePoint& point : points) {
    const glm::dvec2 offset = kappa - glm::dvec2(point.kappa1, point.kappa2);
    const double squared = glm::dot(offset, offset);
    if (squared < coincident) {
      exact += point.color;
      ++hits;
    } else {
      sum += point.color / squared;
      weights += 1.0 / squared;
    }
  }
  return hits > 0 ? exact / static_cast<double>(hits) : sum / weights;
}

std::vector<glm::vec3> curvatureTexels(const Look& look, int size) {
  assert(size > 0);
  std::vector<glm::vec3> texels;
  texels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  const auto centre = [size](int i) { return (2.0 * i + 1.0) / size - 1.0; };
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const glm::dvec2 kappa(centre(column), centre(row));
      texels.emplace_back(look.curvaturePoints ? curvatureColor(*look.curvaturePoints, kappa)
                                               : automaticCurvatureColor(kappa));
    }
  return texels;
}

}  // namespace isolux::scene
