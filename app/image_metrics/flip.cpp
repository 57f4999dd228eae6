#include "app/image_metrics/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace isolux::app {

namespace {

// ---- Images of one number, and filters that are products of one along x and one along y.

struct Plane {
  glm::ivec2 size{0};
  std::vector<double> values;

  double& at(int x, int y) { return values[static_cast<std::size_t>(y * size.x + x)]; }
  double at(int x, int y) const { return values[static_cast<std::size_t>(y * size.x + x)]; }
};

using Taps = std::vector<double>;  // of -radius .. radius

// Pixels beyond the border are those of the border.
Plane filtered(const Plane& image, const Taps& alongX, const Taps& alongY) {
  const int radius = static_cast<int>(alongX.size() / 2);
  Plane rows{image.size, std::vector<double>(image.values.size())}, result = rows;
  for (int y = 0; y < image.size.y; ++y)
    for (int x = 0; x < image.size.x; ++x)
      for (int i = -radius; i <= radius; ++i)
        rows.at(x, y) += alongX[static_cast<std::size_t>(i + radius)] *
                         image.at(std::clamp(x + i, 0, image.size.x - 1), y);
  for (int y = 0; y < image.size.y; ++y)
    for (int i = -radius; i <= radius; ++i) {
      const double weight = alongY[static_cast<std::size_t>(i + radius)];
      const int from = std::clamp(y + i, 0, image.size.y - 1);
      for (int x = 0; x < image.size.x; ++x) result.at(x, y) += weight * rows.at(x, from);
    }
  return result;
}

template <class Function>
Taps tapsOf(int radius, const Function& weight) {
  Taps taps;
  for (int i = -radius; i <= radius; ++i) taps.push_back(weight(static_cast<double>(i)));
  return taps;
}

double sumOf(const Taps& taps) {
  return std::accumulate(taps.begin(), taps.end(), 0.0);
}

// What is above 0 has the sum 1, and what is below it the sum -1.
Taps balanced(Taps taps) {
  double above = 0.0, below = 0.0;
  for (const double tap : taps) (tap > 0.0 ? above : below) += std::abs(tap);
  for (double& tap : taps) tap /= tap > 0.0 ? above : below;
  return taps;
}

Taps normalized(Taps taps) {
  const double sum = sumOf(taps);
  for (double& tap : taps) tap /= sum;
  return taps;
}

// ---- Colours

const glm::dvec3 kWhite(0.950428545, 1.0, 1.088900371);  // XYZ of (1, 1, 1): D65

// BT.709 to XYZ, as columns; its rows sum to kWhite.
const glm::dmat3 kXyzOfRgb(10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0,
                           8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0,
                           4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0);

// The linear opponent space of L*a*b*: luminance, red-green, blue-yellow.
glm::dvec3 opponentOf(const glm::dvec3& rgb) {
  const glm::dvec3 xyz = kXyzOfRgb * rgb / kWhite;
  return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

glm::dvec3 rgbOfOpponent(const glm::dvec3& color) {
  static const glm::dmat3 rgbOfXyz = glm::inverse(kXyzOfRgb);
  const double y = (color.x + 16.0) / 116.0;
  return rgbOfXyz * (kWhite * glm::dvec3(y + color.y / 500.0, y, y - color.z / 200.0));
}

double labRoot(double t) {
  constexpr double delta = 6.0 / 29.0;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
}

// L*a*b*, less colourful where it is dark (Hunt).
glm::dvec3 huntLabOf(const glm::dvec3& rgb) {
  const glm::dvec3 xyz = kXyzOfRgb * rgb / kWhite;
  const glm::dvec3 root(labRoot(xyz.x), labRoot(xyz.y), labRoot(xyz.z));
  const double lightness = 116.0 * root.y - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (root.x - root.y),
          0.01 * lightness * 200.0 * (root.y - root.z)};
}

double hyabDistance(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// The largest differences take a twentieth of the scale: 95 % of it are for up to 0.4 of the largest one,
// which is that of green and blue.
double colorDifference(const glm::dvec3& a, const glm::dvec3& b) {
  constexpr double exponent = 0.7, knee = 0.4, share = 0.95;
  static const double most =
      std::pow(hyabDistance(huntLabOf({0.0, 1.0, 0.0}), huntLabOf({0.0, 0.0, 1.0})), exponent);
  const double difference = std::pow(hyabDistance(a, b), exponent);
  const double bend = knee * most;
  if (difference < bend) return share * difference / bend;
  return share + (1.0 - share) * (difference - bend) / (most - bend);
}

// ---- The eye's contrast sensitivity: sums of Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees.

struct Sensitivity {
  double a, b;
};

constexpr Sensitivity kAchromatic{1.0, 0.0047}, kRedGreen{1.0, 0.0053},
    kBlueYellow[] = {{34.1, 0.04}, {13.5, 0.025}};

Plane seen(const Plane& image, const Sensitivity& kind, double pixelsPerDegree, int radius, double& weight) {
  constexpr double pi = std::numbers::pi;
  const Taps taps = tapsOf(radius, [&](double i) {
    const double x = i / pixelsPerDegree;
    return std::exp(-pi * pi * x * x / kind.b);
  });
  const double sum = sumOf(taps);
  weight = kind.a * std::sqrt(pi / kind.b) * sum * sum;
  const Taps unit = normalized(taps);
  return filtered(image, unit, unit);
}

// Linear colours as the eye's filters leave them, in L*a*b*.
std::vector<glm::dvec3> seenColors(const std::array<Plane, 3>& opponent, double pixelsPerDegree) {
  constexpr double pi = std::numbers::pi;
  const int radius =
      static_cast<int>(std::ceil(3.0 * std::sqrt(kBlueYellow[0].b / (2.0 * pi * pi)) * pixelsPerDegree));
  double weight = 0.0, first = 0.0, second = 0.0;
  const Plane light = seen(opponent[0], kAchromatic, pixelsPerDegree, radius, weight);
  const Plane redGreen = seen(opponent[1], kRedGreen, pixelsPerDegree, radius, weight);
  const Plane wide = seen(opponent[2], kBlueYellow[0], pixelsPerDegree, radius, first);
  const Plane narrow = seen(opponent[2], kBlueYellow[1], pixelsPerDegree, radius, second);
  std::vector<glm::dvec3> colors;
  colors.reserve(light.values.size());
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    const double blueYellow = (first * wide.values[i] + second * narrow.values[i]) / (first + second);
    const glm::dvec3 rgb = rgbOfOpponent({light.values[i], redGreen.values[i], blueYellow});
    colors.push_back(
        huntLabOf({std::clamp(rgb.x, 0.0, 1.0), std::clamp(rgb.y, 0.0, 1.0), std::clamp(rgb.z, 0.0, 1.0)}));
  }
  return colors;
}

// ---- Edges and points

struct Features {
  Plane edges, points;  // lengths of first and second derivatives
};

Plane lengthOf(Plane x, const Plane& y) {
  for (std::size_t i = 0; i < x.values.size(); ++i) x.values[i] = std::hypot(x.values[i], y.values[i]);
  return x;
}

Features featuresOf(const Plane& opponentLight, double pixelsPerDegree) {
  constexpr double widthDegrees = 0.082;  // of what the eye sees best
  const double deviation = 0.5 * widthDegrees * pixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  const auto gaussian = [&](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
  const Taps smooth = normalized(tapsOf(radius, gaussian));
  const Taps slope = balanced(tapsOf(radius, [&](double x) { return -x * gaussian(x); }));
  const Taps bend = balanced(
      tapsOf(radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x); }));
  Plane light = opponentLight;
  for (double& value : light.values) value = (value + 16.0) / 116.0;
  return {lengthOf(filtered(light, slope, smooth), filtered(light, smooth, slope)),
          lengthOf(filtered(light, bend, smooth), filtered(light, smooth, bend))};
}

std::array<Plane, 3> opponentPlanes(const ComparedPicture& picture) {
  std::array<Plane, 3> planes;
  for (Plane& plane : planes) plane.size = picture.size;
  for (const glm::dvec3& linear : picture.linear) {
    const glm::dvec3 color = opponentOf(linear);
    planes[0].values.push_back(color.x);
    planes[1].values.push_back(color.y);
    planes[2].values.push_back(color.z);
  }
  return planes;
}

}  // namespace

std::vector<double> flipImage(const ComparedPicture& reference, const ComparedPicture& test,
                              double pixelsPerDegree) {
  assert(reference.size == test.size && !reference.linear.empty() && pixelsPerDegree > 0.0);
  const std::array<Plane, 3> first = opponentPlanes(reference), second = opponentPlanes(test);
  const std::vector<glm::dvec3> a = seenColors(first, pixelsPerDegree),
                                b = seenColors(second, pixelsPerDegree);
  const Features c = featuresOf(first[0], pixelsPerDegree), d = featuresOf(second[0], pixelsPerDegree);
  std::vector<double> flip(a.size());
  for (std::size_t i = 0; i < flip.size(); ++i) {
    const double feature = std::max(std::abs(c.edges.values[i] - d.edges.values[i]),
                                    std::abs(c.points.values[i] - d.points.values[i]));
    const double lifted = std::sqrt(std::min(feature / std::numbers::sqrt2, 1.0));
    flip[i] = std::pow(colorDifference(a[i], b[i]), 1.0 - lifted);
  }
  return flip;
}

double meanFlip(const ComparedPicture& reference, const ComparedPicture& test, double pixelsPerDegree) {
  const std::vector<double> flip = flipImage(reference, test, pixelsPerDegree);
  return std::accumulate(flip.begin(), flip.end(), 0.0) / static_cast<double>(flip.size());
}

}  // namespace isolux::app
