#include "app/study/surface_reference.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/view_math/surface_pick.h"
#include "render/passes/view_uniforms.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::app {

using scene::Field;

namespace {

constexpr double kFloatRounding = 4.0 * 0x1p-24;  // of a few operations in single precision, relative
constexpr double kBehindVoxels = 1e-6;            // where the search for the crossing behind a hit begins
constexpr std::size_t kGrain = 64;                // pixels at a time: a stop is heard between

std::size_t indexOf(Field field) {
  return static_cast<std::size_t>(field);
}

}  // namespace

SurfaceReference::SurfaceReference(std::shared_ptr<const volume::PreparedVolume> volume,
                                   const scene::Scene& scene, glm::ivec2 size)
    : volume_(std::move(volume)),
      size_(size),
      frame_(scene::frameOf(scene.camera)),
      rayStartMm_(
          render::ViewUniforms(scene.camera, static_cast<double>(size.x) / size.y, volume_->grid().geometry())
              .rayStartMm),
      isovalue_(scene.surfaces.front().value.value()),
      outward_(scene.isosurface.inside == scene::Inside::above ? -1.0 : 1.0) {
  base::Progress unwatched;
  const scene::NoiseModel noise = volume_->derivativeChoices->noise(unwatched);
  noise_ = scene.derivatives.noise.value_or(noise.at(isovalue_));
  noiseBlur_ = noise.correlation;
}

volume::Ray SurfaceReference::rayOf(std::size_t pixel, glm::dvec2 offset) const {
  const glm::dvec2 at = glm::dvec2(volume::Extent2{size_}.at(pixel)) + 0.5;
  const glm::dvec2 ndc(at.x / size_.x * 2.0 - 1.0, 1.0 - at.y / size_.y * 2.0);
  const volume::GridGeometry& geometry = volume_->grid().geometry();
  volume::Ray ray = viewRay(geometry, frame_, ndc, static_cast<double>(size_.x) / size_.y, rayStartMm_);
  ray.origin += glm::dmat3(geometry.voxelFromWorld()) * (offset.x * frame_.right + offset.y * frame_.up);
  return ray;
}

void SurfaceReference::prepare(Field field, base::Progress& progress) {
  cubic_[indexOf(field)] = volume_->cubicFields->make(field, progress);
}

volume::CubicHit SurfaceReference::cast(Field field, const volume::Ray& ray, double isovalue) const {
  const volume::CubicField* const cubic = cubic_[indexOf(field)].get();
  return volume::firstHitOfField(volume_->grid(), field, cubic ? cubic->coefficients.get() : nullptr,
                                 cubic ? cubic->blocks : *volume_->blocks, isovalue, ray);
}

TrueHit SurfaceReference::hitOf(Field field, std::size_t pixel) const {
  volume::Ray ray = rayOf(pixel);
  TrueHit result;
  result.voxelsPerMm = glm::length(ray.direction);
  const auto first = cast(field, ray, isovalue_).hit;
  if (!first) return result;
  result.hit = true;
  result.depthMm = first->t;
  result.voxel = first->voxel;
  if (field == Field::trilinear) {
    const glm::dvec3 gradient = volume::sampleTrilinear(volume_->grid(), first->voxel).gradient;
    result.fromOutside = outward_ * glm::dot(gradient, ray.direction) <= 0.0;
  }
  ray.tMinimum = first->t + kBehindVoxels / result.voxelsPerMm;
  if (const auto next = cast(field, ray, isovalue_).hit) result.nextMm = next->t;
  return result;
}

const std::vector<TrueHit>& SurfaceReference::hitsOf(Field field, base::Progress& progress) {
  Hits& hits = hits_[indexOf(field)];
  if (!hits.empty()) return hits;
  prepare(field, progress);
  Hits found(volume::Extent2{size_}.count());
  volume::parallelPieces(found.size(), kGrain, progress, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = hitOf(field, i);
  });
  hits = std::move(found);
  return hits;
}

SurfaceReference::ShapeSource SurfaceReference::sourceOf(const scene::Derivatives& derivatives,
                                                         base::Progress& progress) {
  const Field field = derivatives.field;
  const double scale = derivatives.scale.value_or(0.0), normalScale = derivatives.normalScale.value_or(0.0);
  prepare(field, progress);
  volume::CubicFields& fields = *volume_->cubicFields;
  return {field, fields.make(field, scale, progress), fields.make(field, normalScale, progress),
          volume::curvatureScale(volume_->grid().geometry(), field, noise_, noiseBlur_, scale)};
}

// As the shader: next to missing voxels the cell's own gradient, and no curvature.
SurfaceReference::KnownSample SurfaceReference::sampleAt(Field field, const volume::ScaledField* scaled,
                                                         const glm::dvec3& voxel) const {
  const volume::Grid& grid = volume_->grid();
  const volume::CubicField* const cubic = cubic_[indexOf(field)].get();
  const volume::FieldSample sample =
      volume::sampleField(grid, field, cubic ? cubic->coefficients.get() : nullptr, voxel, scaled);
  if (scaled || std::isfinite(sample.value)) return {sample};
  return {volume::sampleTrilinear(grid, voxel), false};
}

TrueShape SurfaceReference::shapeAt(const ShapeSource& source, const glm::dvec3& voxel) const {
  const volume::GridGeometry& geometry = volume_->grid().geometry();
  const auto [sample, known] = sampleAt(source.field, source.curvature.get(), voxel);
  const glm::dvec3 gradient = volume::worldGradient(geometry, sample.gradient);
  const volume::PrincipalCurvature curvature =
      volume::principalCurvature(gradient, volume::worldHessian(geometry, sample.hessian), outward_);
  TrueShape shape;
  shape.normal = curvature.normal;
  if (source.normals != source.curvature) {
    const volume::FieldSample seen = sampleAt(source.field, source.normals.get(), voxel).sample;
    shape.normal =
        volume::principalCurvature(volume::worldGradient(geometry, seen.gradient), glm::dmat3(0.0), outward_)
            .normal;
  }
  shape.hasNormal = shape.normal != glm::dvec3(0.0);
  shape.hasCurvature = known && curvature.normal != glm::dvec3(0.0) &&
                       glm::length(gradient) >= volume::kClearGradient * source.noise.gradientNoise;
  shape.kappa1 = curvature.kappa1;
  shape.kappa2 = curvature.kappa2;
  return shape;
}

TrueSurface SurfaceReference::of(Field hitField, const scene::Derivatives& derivatives,
                                 base::Progress& progress) {
  const Hits& hits = hitsOf(hitField, progress);
  const ShapeSource source = sourceOf(derivatives, progress);
  Shapes& shapes = shapes_[{hitField, derivatives.field, derivatives.scale.value_or(0.0),
                            derivatives.normalScale.value_or(0.0)}];
  if (shapes.empty()) {
    Shapes found(hits.size());
    volume::parallelPieces(found.size(), kGrain, progress, {}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (hits[i].hit) found[i] = shapeAt(source, hits[i].voxel);
    });
    shapes = std::move(found);
  }
  return {hits, shapes, source.noise.flatCurvature};
}

bool SurfaceReference::undecided(Field hitField, std::size_t pixel) const {
  const TrueHit& expected = hits_[indexOf(hitField)][pixel];
  const auto differs = [&](const volume::Ray& ray, double isovalue) {
    const volume::CubicHit found = cast(hitField, ray, isovalue);
    if (!found.certain || found.hit.has_value() != expected.hit) return true;
    return expected.hit && !isFirstCrossing(found.hit->t, expected);
  };
  const volume::Ray ray = rayOf(pixel);
  const volume::Grid& grid = volume_->grid();
  const double reach = glm::length(ray.origin) + glm::length(glm::dvec3(grid.dims()));  // voxels
  const double offsetMm = kFloatRounding * reach / expected.voxelsPerMm;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      if (differs(rayOf(pixel, offsetMm * glm::dvec2(x, y)), isovalue_)) return true;
  const double largest = std::max(std::abs(grid.minimum()), std::abs(grid.maximum()));
  return differs(ray, isovalue_ - kFloatRounding * largest) ||
         differs(ray, isovalue_ + kFloatRounding * largest);
}

}  // namespace isolux::app
