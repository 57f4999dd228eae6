#include "tests/volume/cast/caster_checks.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "volume/hit/exact_hit.h"
#include "volume/skip/box_bounds.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/skip/shown_boxes.h"

namespace isolux::test::casting {

using namespace volume;

std::vector<TracerTarget> targets() {
  std::vector<TracerTarget> list = IsosurfaceTracer::availableTargets();
  std::erase(list, TracerTarget::scalar);
  return list;
}

Prepared::Prepared(Grid made, std::vector<double> values, scene::Field of,
                   std::vector<const VoxelMask*> hidden, scene::Inside inside)
    : isovalues(std::move(values)),
      grid_(std::make_shared<Grid>(std::move(made))),
      field_(of),
      hidden_(std::move(hidden)),
      inside_(inside) {
  cubic_ = CubicFields(grid_).make(of, progress_);
  if (!cubic_) blocks_ = std::make_unique<MinMaxBlocks>(*grid_, 8, progress_);
  const double offset = cubic_ && cubic_->coefficients ? cubic_->coefficients->offset : 0.0;
  std::vector<float> stored;
  for (const double value : isovalues)
    stored.push_back(static_cast<float>(grid_->storedOfValue(value) - offset));
  std::vector<std::uint8_t> flags;
  for (const float value : stored) {
    std::vector<std::uint8_t> own;
    blocks().activeBlocks(value, own);
    flags.resize(own.size());
    for (std::size_t i = 0; i < own.size(); ++i) flags[i] |= own[i];
  }
  const BoxBounds ofVoxels(*grid_, MinMaxBlocks(*grid_, BoxBounds::kBlockCells, progress_), progress_);
  const BoxBounds& boxes = cubic_ ? cubic_->boxes : ofVoxels;
  if (hidden_.empty()) {
    boxes.masks(stored, flags, masks_);
    return;
  }
  std::vector<PartlyShown> surfaces;
  for (std::size_t k = 0; k < stored.size(); ++k)
    surfaces.push_back({stored[k], hidden_[k], InsideLevel::of(*grid_, isovalues[k], inside_)});
  shownBoxes(*grid_, boxes, surfaces, cubic_ != nullptr, flags, masks_);
}

HiddenPieces Prepared::hiddenOf(double isovalue) const {
  if (hidden_.empty()) return {};
  const auto at = std::find(isovalues.begin(), isovalues.end(), isovalue) - isovalues.begin();
  return {hidden_[static_cast<std::size_t>(at)], inside_};
}

SurfaceCaster Prepared::caster(TracerTarget target, std::span<const float> rayEnds) const {
  std::vector<double> stored;
  for (const double value : isovalues) stored.push_back(grid_->storedOfValue(value));
  const Coefficients* const coefficients = cubic_ && cubic_->coefficients ? &*cubic_->coefficients : nullptr;
  CastField of{*grid_, field_, coefficients, hidden_, inside_};
  if (region_.cuts()) of.region = &region_, of.clipped = clipped_;
  of.rayEnds = rayEnds;
  return {of, stored, blocks().dims(), masks_, target};
}

CubicHit Prepared::wholeHit(double isovalue, const Ray& ray) const {
  const HiddenPieces hidden = hiddenOf(isovalue);
  return firstHitOfField(*grid_, field_, cubic_ ? cubic_->coefficients.get() : nullptr, blocks(), isovalue,
                         ray, hidden);
}

CubicHit Prepared::firstHit(double isovalue, const Ray& whole) const {
  const auto k = std::find(isovalues.begin(), isovalues.end(), isovalue) - isovalues.begin();
  const bool cut = (clipped_ >> k & 1) != 0;
  CubicHit found = wholeHit(isovalue, whole);
  Ray ray = whole;
  bool certain = found.certain;
  while (cut && found.hit && !region_.contains(found.hit->voxel)) {
    ray.tMinimum = found.hit->t + 1e-7;
    found = wholeHit(isovalue, ray);
    certain = certain && found.certain;
  }
  found.certain = certain;
  return found;
}

PictureRays view(int k, glm::ivec3 dims) {
  const glm::dvec3 middle = 0.5 * glm::dvec3(dims - 1);
  const double size = glm::length(glm::dvec3(dims));
  const double azimuth = 2.399963 * k, height = -0.9 + 1.8 * ((k * 7) % 20) / 19.0;
  const glm::dvec3 back(std::cos(azimuth) * std::sqrt(1.0 - height * height),
                        std::sin(azimuth) * std::sqrt(1.0 - height * height), height);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.1, 0.2, 1.0), back));
  PictureRays rays;
  rays.orthographic = k % 4 == 1;
  const double distance = rays.orthographic ? size : size * (k % 4 == 3 ? 0.12 : k % 4 == 2 ? 0.6 : 1.6);
  rays.eye = middle + distance * back;
  rays.right = right;
  rays.up = glm::cross(back, right);
  rays.forward = -back;
  const double half = rays.orthographic ? 0.45 * size : k % 4 == 3 ? 0.84 : 0.36;
  rays.halfExtent = {static_cast<float>(half * kSize.x / kSize.y), static_cast<float>(half)};
  rays.picture = kSize;
  return rays;
}

Ray rayOf(const PictureRays& rays, glm::dvec2 fragment) {
  const glm::dvec2 plane = (fragment / glm::dvec2(rays.picture) * 2.0 - 1.0) * glm::dvec2(rays.halfExtent);
  const glm::dvec3 offset = plane.x * glm::dvec3(rays.right) + plane.y * glm::dvec3(rays.up);
  Ray ray;
  ray.origin = glm::dvec3(rays.eye) + (rays.orthographic ? offset : glm::dvec3(0.0));
  ray.direction = rays.orthographic
                      ? glm::dvec3(rays.forward)
                      : (glm::dvec3(rays.forward) + offset) / std::sqrt(1.0 + glm::dot(plane, plane));
  return ray;
}

CrossingImage cast(const SurfaceCaster& caster, const PictureRays& rays) {
  CrossingImage picture(kSize);
  caster.castAll(rays, picture);
  return picture;
}

namespace {

// The nearest first crossing of the surfaces, and which.
struct Expected {
  double t = std::numeric_limits<double>::infinity();
  glm::dvec3 voxel{0.0};
  int surface = 0;
  bool rises = false, certain = true;
};

Expected expectedOf(const Prepared& volume, const Ray& ray) {
  Expected nearest;
  for (std::size_t k = 0; k < volume.isovalues.size(); ++k) {
    const CubicHit found = volume.firstHit(volume.isovalues[k], ray);
    const bool certain = nearest.certain && found.certain;
    if (found.hit && found.hit->t < nearest.t)
      nearest = {found.hit->t, found.hit->voxel, static_cast<int>(k), found.hit->entering};
    nearest.certain = certain;
  }
  return nearest;
}

// A crossing where the ray enters the volume lies on either side of its border by rounding.
bool atBorder(const Grid& grid, glm::dvec3 voxel) {
  const glm::dvec3 last(grid.dims() - 1);
  for (int axis = 0; axis < 3; ++axis)
    if (std::min(voxel[axis], last[axis] - voxel[axis]) < 1e-4) return true;
  return false;
}

struct Counts {
  int hits = 0, undecided = 0;
};

void expectHitsOf(const Prepared& volume, const CrossingImage& picture, const PictureRays& rays,
                  const std::string& where, Counts& counts) {
  for (int i = 0; i < kSize.x * kSize.y; ++i) {
    const glm::vec4 point = picture.points[static_cast<std::size_t>(i)];
    const int known = static_cast<int>(picture.infos[static_cast<std::size_t>(i)].y);
    const glm::dvec2 fragment(i % kSize.x + 0.5, i / kSize.x + 0.5);
    const auto agrees = [&](const Expected& expected) {
      if (std::isinf(expected.t)) return point.w < 0.0f;
      return point.w >= 0.0f && glm::distance(glm::dvec3(point), expected.voxel) < 0.02 &&
             (known & 3) == expected.surface &&
             ((known >> 2 >> expected.surface & 1) != 0) == (expected.rises == (volume.grid().slope() > 0.0));
    };
    counts.hits += point.w >= 0.0f;
    const Expected expected = expectedOf(volume, rayOf(rays, fragment));
    if (agrees(expected)) continue;
    bool accepted = !expected.certain || atBorder(volume.grid(), expected.voxel);
    for (const glm::dvec2& step : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
      accepted = accepted || agrees(expectedOf(volume, rayOf(rays, fragment + 0.01 * step)));
    counts.undecided += accepted;
    EXPECT_TRUE(accepted) << where << ", pixel " << i % kSize.x << ' ' << i / kSize.x;
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace

void expectFirstHits(const Prepared& volume, const char* name, int views) {
  for (const TracerTarget target : targets()) {
    const SurfaceCaster caster = volume.caster(target);
    Counts counts;
    for (int k = 0; k < views && !::testing::Test::HasFailure(); ++k) {
      const PictureRays rays = view(k, volume.grid().dims());
      expectHitsOf(volume, cast(caster, rays), rays, std::string(name) + ", view " + std::to_string(k),
                   counts);
    }
    EXPECT_GT(counts.hits, 300 * views) << name;
    EXPECT_LT(counts.undecided, 1 + counts.hits / 1000) << name;
  }
}

Grid changed(const Grid& grid, const std::function<float(glm::ivec3, double)>& change) {
  std::vector<float> voxels;
  const glm::ivec3 dims = grid.dims();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) voxels.push_back(change({x, y, z}, grid.value(x, y, z)));
  return Grid(grid.geometry(), std::move(voxels));
}

Grid withHoles(const Grid& grid) {
  return changed(grid, [](glm::ivec3 p, double v) {
    return base::hash64(static_cast<std::uint64_t>((p.z / 3 * 97 + p.y / 3) * 97 + p.x / 3)) % 7 == 0
               ? std::numeric_limits<float>::quiet_NaN()
               : static_cast<float>(v);
  });
}

}  // namespace isolux::test::casting
