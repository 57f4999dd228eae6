#include "volume/prepared/first_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace isolux::volume {

namespace {

constexpr double kPortrait = 7.0, kThreeQuarters = 20.0, kOfLyingSlab = 55.0;  // degrees above
constexpr double kLying = 0.3;                           // height, in parts of the lesser of length and width
constexpr double kNearlyAsGood = 0.97;                   // the earlier of two directions is taken
constexpr double kFlatDepth = 0.015;                     // of the whole size: what stands on the ground
constexpr double kFlatFacing = 0.95;                     // cosine
constexpr double kLeastFlat = 0.03, kMuchFlatter = 2.5;  // share of the samples; times the habitual side's
constexpr std::size_t kFewestSamples = 500;              // samples that tell anything
constexpr std::size_t kPixels = 64;                      // of the picture that visible area is measured in
constexpr double kPlain = 0.1;        // what a pixel without relief shows, in parts of an edge's
constexpr double kMostSlanted = 4.0;  // area of a pixel that is seen at a grazing angle

double radiansOf(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

Bounds<glm::dvec3> boxOf(std::span<const OutlineSample> samples) {
  Bounds<glm::dvec3> box;
  for (const OutlineSample& sample : samples) box.add(sample.positionMm);
  return box;
}

// Which part of the surface lies on the ground when `up` is up.
double standingOn(std::span<const OutlineSample> samples, glm::dvec3 up) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const OutlineSample& sample : samples) lowest = std::min(lowest, glm::dot(up, sample.positionMm));
  const double reach = lowest + kFlatDepth * glm::length(boxOf(samples).size());
  const auto onGround = std::ranges::count_if(samples, [&](const OutlineSample& sample) {
    return glm::dot(up, sample.positionMm) < reach && glm::dot(up, sample.normal) < -kFlatFacing;
  });
  return static_cast<double>(onGround) / static_cast<double>(samples.size());
}

glm::dvec3 upOfSurface(std::span<const OutlineSample> samples, glm::dvec3 habit) {
  const double flat = std::max(kLeastFlat, kMuchFlatter * standingOn(samples, habit));
  glm::dvec3 best = habit;
  double most = flat;
  for (int axis = 2; axis >= 0; --axis)
    for (const double sign : {1.0, -1.0}) {
      glm::dvec3 up(0.0);
      up[axis] = sign;
      if (const double share = standingOn(samples, up); share > most) {
        most = share;
        best = up;
      }
    }
  return best;
}

// Area of the surface that is seen from there, in pixels of a picture that holds all of it; where it turns
// from a pixel to the next it shows more.
double visibleShape(std::span<const OutlineSample> samples, glm::dvec3 toEye, glm::dvec3 up) {
  const glm::dvec3 right = glm::normalize(glm::cross(up, toEye)), top = glm::cross(toEye, right);
  const Bounds<glm::dvec3> box = boxOf(samples);
  const glm::dvec3 centre = 0.5 * (box.low + box.high);
  const double size = glm::length(box.size());
  if (!(size > 0.0)) return 0.0;
  struct Pixel {
    double depth = -std::numeric_limits<double>::infinity();
    glm::dvec3 normal{0.0};
    bool covered() const { return std::isfinite(depth); }
  };
  std::vector<Pixel> pixels(kPixels * kPixels);
  for (const OutlineSample& sample : samples) {
    const glm::dvec3 d = (sample.positionMm - centre) / size;  // within half of 1
    const glm::ivec2 at = glm::clamp(
        glm::ivec2((glm::dvec2(glm::dot(right, d), glm::dot(top, d)) + 0.5) * static_cast<double>(kPixels)),
        glm::ivec2(0), glm::ivec2(static_cast<int>(kPixels) - 1));
    Pixel& pixel = pixels[static_cast<std::size_t>(at.y) * kPixels + static_cast<std::size_t>(at.x)];
    if (const double depth = glm::dot(toEye, d); depth > pixel.depth) pixel = {depth, sample.normal};
  }
  double shape = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Pixel& pixel = pixels[i];
    if (!pixel.covered()) continue;
    const double facing = std::abs(glm::dot(toEye, pixel.normal));
    double turn = 0.0;
    for (const std::size_t beside : {i + 1, i + kPixels})
      if (beside < pixels.size() && pixels[beside].covered())
        turn += 0.5 * (1.0 - glm::dot(pixel.normal, pixels[beside].normal));
    shape += std::min(kMostSlanted, 1.0 / std::max(facing, 1e-9)) * (kPlain + std::min(turn, 1.0));
  }
  return shape;
}

}  // namespace

FirstView firstView(std::span<const OutlineSample> samples, scene::WorldAxes axes) {
  const glm::dvec3 habit = scene::upOf(axes), habitualFront = scene::frontOf(axes);
  const auto above = [](glm::dvec3 side, glm::dvec3 up, double degrees) {
    return std::cos(radiansOf(degrees)) * side + std::sin(radiansOf(degrees)) * up;
  };
  if (axes == scene::WorldAxes::anatomical || samples.size() < kFewestSamples)
    return {above(habitualFront, habit, kPortrait), habit};
  const glm::dvec3 up = upOfSurface(samples, habit);
  const glm::dvec3 front =
      std::abs(glm::dot(up, habitualFront)) > 0.5 ? glm::dot(up, habitualFront) * habit : habitualFront;
  const glm::dvec3 right = glm::cross(up, front);
  const glm::dvec3 size = boxOf(samples).size();
  const double height = std::abs(glm::dot(size, up));
  const glm::dvec2 ground(std::abs(glm::dot(size, front)), std::abs(glm::dot(size, right)));
  const double degrees = height < kLying * std::min(ground.x, ground.y) ? kOfLyingSlab : kThreeQuarters;
  FirstView best{{}, up};
  double most = 0.0;
  for (const double azimuth : {30.0, -30.0, 60.0, -60.0, 150.0, -150.0, 120.0, -120.0}) {
    const glm::dvec3 side = std::cos(radiansOf(azimuth)) * front + std::sin(radiansOf(azimuth)) * right;
    const glm::dvec3 toEye = above(side, up, degrees);
    const double shape = visibleShape(samples, toEye, up);
    if (shape * kNearlyAsGood <= most) continue;
    most = shape;
    best.toEye = toEye;
  }
  return best;
}

}  // namespace isolux::volume
