// Hits of the processor's executor (volume/cast), in float: on the surface within what they state, and none
// missed that is clear. docs/explanation/numerics.md, "Hard cases", derives the bounds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/properties/exchanged_axes.h"
#include "tests/properties/property_run.h"
#include "tests/properties/searched_ray.h"
#include "tests/volume/cast/caster_checks.h"
#include "volume/field/value_scaling.h"

namespace isolux::test {
namespace {

using casting::Prepared;
using volume::CrossingImage;
using volume::Grid;
using volume::TracerTarget;

constexpr double kUnit = 0x1p-24, kTiny = 0x1p-149;  // of float: half an ulp of 1, and the least number
constexpr int kUndecidedBit = 64;

// A texel in stored units (SurfaceCaster's scale), and what values are less.
struct Texel {
  double size = 1.0, offset = 0.0;
};

Texel texelOf(const Grid& grid) {
  const std::size_t bytes = volume::bytesOf(grid.storedType());
  if (bytes == 1) return {255.0, 0.0};
  if (bytes == 2) return {65535.0, 0.0};
  const volume::ValueScaling scaling = volume::scalingOf(grid.storedMinimum(), grid.storedMaximum());
  return {std::ldexp(1.0, scaling.exponent), static_cast<double>(scaling.offset)};
}

// What a picture of floats may be off by, stored units.
struct Bounds {
  const DoubleField& field;
  double isovalue, offset, operations;

  // Of f - isovalue at a point of floats: the subtraction of offset and isovalue, and `operations` roundings
  // of the largest sample less both.
  double ofValue() const {
    const double largest = std::max(std::abs(field.least() - offset), std::abs(field.most() - offset)) +
                           std::abs(isovalue - offset);
    return operations * (kUnit * largest + kTiny);
  }
  // Of that at a hit: `apart` is how far the ray of floats is off, voxels; roots are searched to 1e-6 of a
  // cell's segment, along which the cubic changes by at most six times its range.
  double ofHit(const glm::dvec3& voxel, double apart) const {
    return ofValue() + field.rangeAt(voxel) * (3.0 * apart + 6.0 * 1e-6);
  }
  // The largest of any hit.
  double ofAnyHit(double apart) const { return ofValue() + field.range() * (3.0 * apart + 6.0 * 1e-6); }
};

std::string pixelText(const char* what, const char* field, glm::ivec2 pixel, double is, double limit) {
  std::ostringstream text;
  text << what << ": " << field << ", pixel " << pixel.x << ' ' << pixel.y << ", " << is << " where " << limit
       << " is the bound";
  return text.str();
}

struct Kind {
  scene::Field field;
  const char* name;
  double operations;
};
constexpr Kind kKinds[] = {{scene::Field::trilinear, "trilinear", 24.0},
                           {scene::Field::cubic, "cubic", 200.0},
                           {scene::Field::cubic_interpolating, "cubic_interpolating", 200.0}};

// Calls check(kind, field, bounds, prepared, rays, picture) for each field, on an instruction set of this
// machine.
template <class Check>
std::string eachPicture(const PropertyCase& made, const Check& check) {
  const Grid grid = made.grid();
  const double isovalue = made.isovalueIn(grid);
  const volume::PictureRays rays = raysOf(made.camera(grid.geometry()), grid.geometry(), made.picture);
  const std::vector<TracerTarget> targets = casting::targets();
  for (std::size_t k = 0; k < std::size(kKinds); ++k) {
    const Kind& kind = kKinds[k];
    const Prepared prepared(made.grid(), {isovalue}, kind.field);
    const DoubleField field(grid, kind.field);
    const Texel texel = texelOf(grid);
    const Bounds bounds{field, grid.storedOfValue(isovalue), texel.offset, kind.operations};
    const volume::SurfaceCaster caster = prepared.caster(targets[(made.seed + k) % targets.size()]);
    CrossingImage picture(made.picture);
    caster.castAll(rays, picture);
    if (std::string wrong = check(kind, bounds, rays, picture, texel); !wrong.empty()) return wrong;
  }
  return {};
}

std::string hitsLieOnTheSurface(const PropertyCase& made) {
  return eachPicture(
      made,
      [&](const Kind& kind, const Bounds& bounds, const volume::PictureRays& rays,
          const CrossingImage& picture, const Texel& texel) -> std::string {
        for (std::size_t i = 0; i < picture.points.size(); ++i) {
          const glm::ivec2 pixel(static_cast<int>(i) % made.picture.x, static_cast<int>(i) / made.picture.x);
          const glm::dvec4 point(picture.points[i]);
          const glm::dvec2 info(picture.infos[i]);
          for (int k = 0; k < 4; ++k)
            if (!std::isfinite(point[k])) return pixelText("not finite", kind.name, pixel, point[k], 0.0);
          if (!std::isfinite(info.x) || info.x < 0.0)
            return pixelText("not finite", kind.name, pixel, info.x, 0.0);
          if (point.w < 0.0) continue;
          const volume::Ray ray = rayThrough(rays, glm::dvec2(pixel) + 0.5);
          const double apart = roundingOf(rays, made.dims, point.w);
          const glm::dvec3 voxel(point), onRay = ray.origin + point.w * ray.direction;
          for (int axis = 0; axis < 3; ++axis) {
            const double outside = std::max(-voxel[axis], voxel[axis] - (made.dims[axis] - 1));
            if (outside > apart) return pixelText("outside the volume", kind.name, pixel, outside, apart);
            const double beside = std::abs(voxel[axis] - onRay[axis]);
            if (beside > apart) return pixelText("beside its ray", kind.name, pixel, beside, apart);
          }
          const double off = std::abs(bounds.field(voxel) - bounds.isovalue);
          if (std::isnan(off)) continue;  // on the border of a gap
          if (off > bounds.ofHit(voxel, apart))
            return pixelText("off the surface", kind.name, pixel, off, bounds.ofHit(voxel, apart));
          if (kind.field == scene::Field::cubic_interpolating) continue;  // texels of their own
          const double stated = std::abs(info.x * texel.size - off);
          if (info.x > 0.0 && stated > bounds.ofValue())
            return pixelText("not the error that is stated", kind.name, pixel, stated, bounds.ofValue());
        }
        return {};
      });
}

TEST(CasterProperties, HitsLieOnTheSurface) {
  expectHolds("HitsLieOnTheSurface", 0.10, hitsLieOnTheSurface);
}

std::string noClearCrossingIsMissed(const PropertyCase& made) {
  return eachPicture(
      made,
      [&](const Kind& kind, const Bounds& bounds, const volume::PictureRays& rays,
          const CrossingImage& picture, const Texel&) -> std::string {
        const std::size_t step = kind.field == scene::Field::trilinear ? 1 : 13;
        for (std::size_t i = made.seed % step; i < picture.points.size(); i += step) {
          const glm::ivec2 pixel(static_cast<int>(i) % made.picture.x, static_cast<int>(i) / made.picture.x);
          if ((static_cast<int>(picture.infos[i].y) & kUndecidedBit) != 0) continue;
          const volume::Ray ray = rayThrough(rays, glm::dvec2(pixel) + 0.5);
          const double size = glm::length(ray.direction);
          // Behind this nothing is seen.
          const double tEnd =
              (glm::distance(ray.origin, 0.5 * glm::dvec3(made.dims)) + glm::length(glm::dvec3(made.dims))) /
              size;
          const double apart = roundingOf(rays, made.dims, tEnd);
          const auto clear =
              firstClearCrossing(bounds.field, bounds.isovalue, bounds.ofAnyHit(apart), apart, ray);
          if (!clear) continue;
          const double t = static_cast<double>(picture.points[i].w);
          if (!(t >= 0.0 && t <= clear->t + 4.0 * apart / size))
            return pixelText("a clear crossing is missed", kind.name, pixel, t, clear->t);
        }
        return {};
      });
}

TEST(CasterProperties, NoClearCrossingIsMissed) {
  expectHolds("NoClearCrossingIsMissed", 0.12, noClearCrossingIsMissed);
}

// Another volume with rays of its own, that shows what the case shows.
struct Twin {
  const char* what;
  Grid grid;
  double isovalue;
  volume::PictureRays rays;
  AxisExchange exchange{};
  double factor = 1.0;  // of its values
};

Bounds boundsOf(const DoubleField& field, const Grid& grid, double isovalue, const Kind& kind) {
  return {field, grid.storedOfValue(isovalue), texelOf(grid).offset, kind.operations};
}

// The twin's hits, brought back, lie on the case's surface and rays, and none is behind a clear crossing of
// the case.
std::string showsTheSame(const PropertyCase& made, const Bounds& bounds, const volume::PictureRays& rays,
                         const Twin& twin, const Kind& kind) {
  const DoubleField twinField(twin.grid, kind.field);
  const double ofValue =
      std::max(bounds.ofValue(), boundsOf(twinField, twin.grid, twin.isovalue, kind).ofValue() / twin.factor);
  const Prepared prepared(Grid(twin.grid), {twin.isovalue}, kind.field);
  const std::vector<TracerTarget> targets = casting::targets();
  CrossingImage picture(made.picture);
  prepared.caster(targets[made.seed % targets.size()]).castAll(twin.rays, picture);
  const auto rounding = [&](double t) {
    return roundingOf(rays, made.dims, t) + roundingOf(twin.rays, twin.grid.dims(), t);
  };
  const glm::dvec3 middle = 0.5 * glm::dvec3(made.dims);
  for (std::size_t i = 0; i < picture.points.size(); ++i) {
    const glm::ivec2 pixel(static_cast<int>(i) % made.picture.x, static_cast<int>(i) / made.picture.x);
    const volume::Ray ray = rayThrough(rays, glm::dvec2(pixel) + 0.5);
    const glm::dvec4 point(picture.points[i]);
    if (point.w >= 0.0) {
      const double apart = rounding(point.w);
      const glm::dvec3 voxel = twin.exchange.pointBefore(glm::dvec3(point), made.dims);
      const glm::dvec3 beside = glm::abs(voxel - (ray.origin + point.w * ray.direction));
      if (std::max({beside.x, beside.y, beside.z}) > apart)
        return pixelText(twin.what, "beside its ray", pixel, std::max({beside.x, beside.y, beside.z}), apart);
      const double off = std::abs(bounds.field(voxel) - bounds.isovalue);
      const double limit = ofValue + bounds.field.rangeAt(voxel) * (3.0 * apart + 6.0 * 1e-6);
      if (off > limit) return pixelText(twin.what, "off the surface", pixel, off, limit);
    }
    if (i % 5 != made.seed % 5 || (static_cast<int>(picture.infos[i].y) & kUndecidedBit) != 0) continue;
    const double size = glm::length(ray.direction);
    const double apart =
        rounding((glm::distance(ray.origin, middle) + glm::length(glm::dvec3(made.dims))) / size);
    const double margin = ofValue + bounds.field.range() * (3.0 * apart + 6.0 * 1e-6);
    const auto clear = firstClearCrossing(bounds.field, bounds.isovalue, margin, apart, ray);
    if (clear && !(point.w >= 0.0 && point.w <= clear->t + 4.0 * apart / size))
      return pixelText(twin.what, "a clear crossing is missed", pixel, point.w, clear->t);
  }
  return {};
}

// Integers, which sums, signs and products leave exact. That the world may be turned is a matter of the rays:
// InvarianceProperties.TheWorldMayBeTurned.
std::string picturesStay(const PropertyCase& drawn) {
  PropertyCase made = drawn;
  made.type = "int8", made.slope = 1.0, made.intercept = 0.0;
  const Grid grid = made.grid();
  const glm::ivec3 dims = grid.dims();
  const double isovalue = std::round(4.0 * made.isovalueIn(grid)) / 4.0;
  const volume::PictureRays rays = raysOf(made.camera(grid.geometry()), grid.geometry(), made.picture);
  const AxisExchange exchange = exchangeOf(made.seed);
  volume::PictureRays exchangedRays = rays;
  exchangedRays.eye = glm::vec3(exchange.point(glm::dvec3(rays.eye), dims));
  for (glm::vec3 volume::PictureRays::*axis :
       {&volume::PictureRays::right, &volume::PictureRays::up, &volume::PictureRays::forward})
    exchangedRays.*axis = glm::vec3(exchange.direction(glm::dvec3(rays.*axis)));
  const int shift = static_cast<int>(made.seed % 20001) - 10000;
  std::vector<std::int16_t> shifted, turned;
  for (const std::int8_t v : std::get<std::vector<std::int8_t>>(grid.voxels())) {
    shifted.push_back(static_cast<std::int16_t>(v + shift));
    turned.push_back(static_cast<std::int16_t>(-v));
  }
  const Twin twins[] = {
      {"axes exchanged", exchanged(grid, exchange), isovalue, exchangedRays, exchange},
      {"a constant added", Grid(grid.geometry(), shifted), isovalue + shift, rays},
      {"as floats, times three",
       casting::changed(grid, [](glm::ivec3, double v) { return static_cast<float>(3.0 * v); }),
       3.0 * isovalue,
       rays,
       {},
       3.0},
      {"turned over", Grid(grid.geometry(), turned), -isovalue, rays},
  };
  const Kind& kind = kKinds[made.seed % std::size(kKinds)];
  const DoubleField field(grid, kind.field);
  const Bounds bounds = boundsOf(field, grid, isovalue, kind);
  for (const Twin& twin : twins)
    if (std::string wrong = showsTheSame(made, bounds, rays, twin, kind); !wrong.empty())
      return std::string(kind.name) + ", " + wrong;
  return {};
}

TEST(CasterProperties, PicturesStayWhenAxesAndValuesChange) {
  expectHolds("PicturesStay", 0.06, picturesStay);
}

}  // namespace
}  // namespace isolux::test
