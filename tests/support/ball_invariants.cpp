#include "tests/support/ball_invariants.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "volume/field/reconstruct.h"

namespace isolux::test {

namespace {

constexpr double kStep = 0.25;  // voxels

struct InsideMoments {
  double volume = 0.0;
  glm::dvec3 first{0.0};
  glm::dmat3 second{0.0};
};

// About the middle of the ball, voxels.
InsideMoments momentsOf(const volume::Grid& grid, double isovalue, glm::dvec3 voxel, double radius) {
  InsideMoments moments;
  const int reach = static_cast<int>(std::ceil(radius / kStep));
  const double weight = kStep * kStep * kStep;
  for (int k = -reach; k < reach; ++k)
    for (int j = -reach; j < reach; ++j)
      for (int i = -reach; i < reach; ++i) {
        const glm::dvec3 d = kStep * (glm::dvec3(i, j, k) + 0.5);
        if (glm::dot(d, d) > radius * radius) continue;
        if (!(volume::sampleTrilinear(grid, voxel + d).value >= isovalue)) continue;
        moments.volume += weight;
        moments.first += weight * d;
        moments.second += weight * glm::outerProduct(d, d);
      }
  return moments;
}

}  // namespace

BallCurvature ballCurvature(const volume::Grid& grid, double isovalue, glm::dvec3 voxel,
                            double radiusVoxels) {
  const double r = radiusVoxels, mm = grid.geometry().spacingMm().x;
  const InsideMoments inside = momentsOf(grid, isovalue, voxel, r);
  BallCurvature out;
  out.mean = 4.0 / (std::numbers::pi * std::pow(r, 4)) *
             (2.0 * std::numbers::pi / 3.0 * std::pow(r, 3) - inside.volume) / mm;
  const glm::dvec3 barycentre = inside.first / inside.volume, n = glm::normalize(barycentre);
  const glm::dmat3 about = inside.second - inside.volume * glm::outerProduct(barycentre, barycentre);
  // In the tangent plane: a 2x2 matrix.
  const glm::dvec3 u = glm::normalize(
      glm::cross(n, std::abs(n.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0)));
  const glm::dvec3 v = glm::cross(n, u);
  const double a = glm::dot(u, about * u), b = glm::dot(u, about * v), c = glm::dot(v, about * v);
  const double root = std::hypot(0.5 * (a - c), b), most = 0.5 * (a + c) + root, least = 0.5 * (a + c) - root;
  // More curvature, smaller moment.
  const auto kappa = [&](double own, double other) {
    return (6.0 / (std::numbers::pi * std::pow(r, 6)) * (other - 3.0 * own) + 8.0 / (5.0 * r)) / mm;
  };
  out.kappa1 = kappa(least, most);
  out.kappa2 = kappa(most, least);
  return out;
}

}  // namespace isolux::test
