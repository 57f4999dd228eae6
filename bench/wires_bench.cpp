// Wires of one to two voxels against their closed form: which rays miss them, and by how much hits are off,
// for each field of hits, without and with noise.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "base/quantiles.h"
#include "bench/bench.h"
#include "volume/derived/cubic_fields.h"
#include "volume/hit/exact_cubic_hit.h"
#include "volume/hit/exact_hit.h"
#include "volume/phantom/phantom.h"

namespace isolux::bench {
namespace {

using scene::Field;
using volume::Grid;

// The phantom `wires` as volume/phantom/phantom.h states it, in voxels around the middle.
class Wires {
 public:
  explicit Wires(int size) : edge_(size - 1) {}
  double radius() const {
    return 0.6 * edge_ / 127.0 * std::sqrt(2.0 * std::log(2.0));
  }  // at half the profile
  double distance(glm::dvec3 q) const {
    constexpr double lean = 40.0 / 180.0 * std::numbers::pi;
    double nearest = std::numeric_limits<double>::infinity();
    for (int ring = 0; ring < 6; ++ring) {
      const double turn = ring * std::numbers::pi / 3.0;
      const glm::dvec3 axis(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean));
      const double along = glm::dot(q, axis);
      nearest = std::min(nearest, std::hypot(along, glm::length(q - along * axis) - 0.3 * edge_));
    }
    return nearest;
  }
  // A ray steps as far as the nearest wire lets it.
  bool isHitBy(glm::dvec3 origin, glm::dvec3 direction) const {
    double t = 0.0;
    for (int step = 0; step < 500 && t < 3.0 * edge_; ++step) {
      const double away = distance(origin + t * direction) - radius();
      if (away < 1e-6) return true;
      t += std::max(away, 1e-4);
    }
    return false;
  }

 private:
  double edge_;
};

struct Judged {
  int wires = 0, missed = 0, invented = 0;  // rays
  std::vector<double> errors;               // of hits: distance from the true surface, voxels
};

template <class FirstHit>
Judged judge(const Wires& wires, int size, const FirstHit& firstHit) {
  constexpr int directions = 4, rays = 100;  // per axis of a picture
  const double middle = 0.5 * (size - 1), reach = 0.36 * size;
  Judged judged;
  for (int d = 0; d < directions; ++d) {
    const double z = 1.0 - (2.0 * d + 1.0) / directions, turn = 2.4 * d, r = std::sqrt(1.0 - z * z);
    const glm::dvec3 along(r * std::cos(turn), r * std::sin(turn), z);
    const glm::dvec3 right = glm::normalize(glm::cross(along, glm::dvec3(0.3, 0.5, 0.8))),
                     up = glm::cross(right, along);
    for (int j = 0; j < rays; ++j)
      for (int i = 0; i < rays; ++i) {
        const glm::dvec3 q = reach * ((2.0 * i + 1.0) / rays - 1.0) * right +
                             reach * ((2.0 * j + 1.0) / rays - 1.0) * up - 1.0 * size * along;
        const bool expected = wires.isHitBy(q, along);
        const std::optional<volume::RayHit> hit =
            firstHit(volume::Ray{.origin = q + middle, .direction = along});
        if (expected) ++judged.wires;
        if (expected && !hit) ++judged.missed;
        if (!expected && hit) ++judged.invented;
        if (hit) judged.errors.push_back(std::abs(wires.distance(hit->voxel - middle) - wires.radius()));
      }
  }
  return judged;
}

void judgeSize(int size, double noise) {
  constexpr double isovalue = 500.0;
  base::Progress progress;
  volume::PhantomRequest request;
  request.name = "wires";
  request.size = size;
  request.noise = 1000.0 * noise;
  const auto grid = std::make_shared<const Grid>(volume::makePhantom(request, progress));
  const volume::MinMaxBlocks blocks(*grid, 8, progress);
  volume::CubicFields fields(grid);
  const auto cubic = fields.make(Field::cubic, progress),
             interpolating = fields.make(Field::cubic_interpolating, progress);
  const Wires wires(size);
  const auto print = [&](const char* name, Judged judged) {
    std::sort(judged.errors.begin(), judged.errors.end());
    const auto percent = [&](int rays) { return 100.0 * rays / judged.wires; };
    const auto quantile = [&](double part) {
      return judged.errors.empty() ? 0.0 : base::quantile(judged.errors, part);
    };
    std::printf(
        "  %7.2f %6.0f %%  %-20s %6.1f %% missed %6.1f %% invented   off by %.3f, 90 %% %.3f voxels\n",
        2.0 * wires.radius(), 100.0 * noise, name, percent(judged.missed), percent(judged.invented),
        quantile(0.5), quantile(0.9));
  };
  print("trilinear", judge(wires, size, [&](const volume::Ray& ray) {
          return volume::firstHit(*grid, blocks, isovalue, ray);
        }));
  print("cubic", judge(wires, size, [&](const volume::Ray& ray) {
          return volume::firstHitOfField(*grid, Field::cubic, nullptr, cubic->blocks, isovalue, ray).hit;
        }));
  print("cubic_interpolating", judge(wires, size, [&](const volume::Ray& ray) {
          return volume::firstHitOfField(*grid, Field::cubic_interpolating, interpolating->coefficients.get(),
                                         interpolating->blocks, isovalue, ray)
              .hit;
        }));
}

void run() {
  std::printf("  voxels  noise  field of hits (percent of the rays that meet a wire)\n");
  for (const int size : {96, 128, 192})
    for (const double noise : {0.0, 0.05, 0.1}) judgeSize(size, noise);
}

const Registration registration("wires", "hits of wires of one to two voxels against their closed form", run);

}  // namespace
}  // namespace isolux::bench
