#include "app/accuracy/picture_errors.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "app/view_math/surface_pick.h"
#include "base/quantiles.h"
#include "render/passes/view_uniforms.h"
#include "scene/rules/ghosts.h"
#include "scene/rules/needs.h"
#include "volume/clip/cut_faces.h"
#include "volume/error/derivative_error.h"
#include "volume/error/hit_error.h"
#include "volume/field/curvature.h"
#include "volume/measure/surface_point.h"
#include "volume/measure/voxel_noise.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::app {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kUnbounded = std::numeric_limits<float>::infinity();
constexpr std::size_t kPixelGrain = 64;  // pixels between two looks at Progress
// 95 % of a normal distribution lie within so many deviations, of one with two components within the second.
constexpr double kNoiseDeviations = 1.960, kNoiseDeviationsOfPlane = 2.448;
constexpr double kUsualError = 0.99;  // of the fields' errors at hits: what is taken where nothing is hit

std::atomic<std::size_t> runs{0};

// Not smaller than the double.
float roundedUp(double bound) {
  const auto near = static_cast<float>(bound);
  return static_cast<double>(near) < bound ? std::nextafter(near, kUnbounded) : near;
}

struct ShapeFields {
  std::shared_ptr<const volume::CubicField> field;
  std::shared_ptr<const volume::ScaledField> scaled;
  volume::DerivedShape shape;
  volume::CurvatureScale noise;
};

// What is the same for all pixels of a picture, and what is said of one.
class PictureEvaluator {
 public:
  PictureEvaluator(const volume::PreparedVolume& volume, const scene::Scene& scene, const DrawnHits& drawn,
                   base::Progress& progress)
      : volume_(volume),
        drawn_(drawn),
        frame_(scene::frameOf(scene.camera)),
        aspect_(static_cast<double>(drawn.size.x) / drawn.size.y),
        view_(scene.camera, aspect_, volume.grid().geometry()),
        rays_(view_.rays(drawn.size, glm::ivec2(0))),
        sampled_(scene.hit.method == scene::HitMethod::sampled),
        isovalues_(scene::seenIsovalues(scene)),
        cubic_(volume.cubicFields->make(scene.hit.field, progress)),
        source_{volume.grid(), cubic_ ? cubic_->blocks : *volume.blocks, scene.hit.field,
                cubic_ ? cubic_->coefficients.get() : nullptr, drawn.onProcessor},
        hidden_(volume::hiddenOf(scene, *volume.pieces, progress)),
        cut_(scene, volume.grid().geometry()),
        inside_(scene.isosurface.inside),
        data_(volume::voxelNoise(volume, scene, progress)) {
    if (scene::showsCutFaces(scene)) faces_.emplace(volume.grid(), *volume.cubicFields, scene, hidden_);
    const scene::NoiseModel model = volume.derivativeChoices->noise(progress);
    const double noise = scene.derivatives.noise.value_or(model.at(scene.surfaces.front().value.value()));
    normals_.emplace(fieldsOf(scene, scene.derivatives.normalScale.value_or(0.0), noise, model, progress));
    curvature_.emplace(fieldsOf(scene, scene.derivatives.scale.value_or(0.0), noise, model, progress));
  }

  volume::HitEnclosure enclose(std::size_t pixel, double fieldErrorElsewhere) const {
    const glm::dvec2 at = middleOf(pixel);
    volume::Ray ray = rayAt(at);
    if (faces_)
      if (const auto face = faces_->at(ray)) ray.tMaximum = face->t;
    constexpr std::size_t mostStretches = volume::ClipRegion::kMostRemoved + 1;
    std::vector<volume::RaySurface> surfaces;
    surfaces.reserve(isovalues_.size() * mostStretches);
    volume::Ray whole = ray;
    whole.tMinimum = -std::numeric_limits<double>::infinity();
    whole.tMaximum = std::numeric_limits<double>::infinity();
    for (const double isovalue : isovalues_)
      for (const auto& [begin, end] : cut_.segmentsOf(isovalue, whole))
        surfaces.push_back({isovalue, volume::hiddenAt(hidden_, isovalue), begin, end});
    return volume::encloseHit(source_, surfaces, rays_, {at.x, drawn_.size.y - at.y}, ray, view_.rayStartMm,
                              fieldErrorElsewhere);
  }

  // Of a pixel that is hit.
  void judge(std::size_t pixel, volume::HitEnclosure hit, PictureErrors& out) const {
    const double depth = drawn_.depthMm[pixel];
    if (std::isnan(depth) || !hit.certain) return refuse(pixel, out);
    const volume::Ray ray = rayAt(middleOf(pixel));
    const auto pointAt = [&](double t) { return ray.origin + t * ray.direction; };
    const glm::dvec3 drawnVoxel(drawn_.voxel[3 * pixel], drawn_.voxel[3 * pixel + 1],
                                drawn_.voxel[3 * pixel + 2]);
    const std::array<glm::dvec3, 2> ends{pointAt(hit.t + hit.randomPart * (hit.first - hit.t)),
                                         pointAt(hit.t + hit.randomPart * (hit.last - hit.t))};
    // Samples at steps are elsewhere than the arithmetic alone would put them.
    const bool elsewhere = std::abs(depth - hit.t) > hit.bound;
    out.elsewhere[pixel] = elsewhere ? 1 : 0;
    if (elsewhere) hit.bound = std::abs(depth - hit.t);
    out.depthMm[pixel] = roundedUp(hit.bound);
    if (sampled_ || elsewhere) hit.shifted = drawnVoxel;
    out.depthNoiseMm[pixel] = depthNoise(hit, ray);
    judgeShape(pixel, hit, ends, out);
  }
  static void refuse(std::size_t pixel, PictureErrors& out) {
    out.certain[pixel] = 0;
    out.depthMm[pixel] = out.normalDegrees[pixel] = out.curvature[pixel] = kUnbounded;
  }

 private:
  glm::dvec2 middleOf(std::size_t pixel) const {
    return glm::dvec2(volume::Extent2{drawn_.size}.at(pixel)) + 0.5;
  }

  volume::Ray rayAt(glm::dvec2 fromTop) const {
    const glm::dvec2 ndc(fromTop.x / drawn_.size.x * 2.0 - 1.0, 1.0 - fromTop.y / drawn_.size.y * 2.0);
    return viewRay(volume_.grid().geometry(), frame_, ndc, aspect_, view_.rayStartMm);
  }

  ShapeFields fieldsOf(const scene::Scene& scene, double scaleMm, double noise,
                       const scene::NoiseModel& model, base::Progress& progress) const {
    const scene::Field field = scene.derivatives.field;
    const auto cubic = volume_.cubicFields->make(field, progress);
    const auto scaled = volume_.cubicFields->make(field, scaleMm, progress);
    return {cubic,
            scaled,
            {volume_.grid(), field, cubic ? cubic->coefficients.get() : nullptr, scaled.get(),
             scene.derivatives.fetch, scene.isosurface.inside == scene::Inside::above ? -1.0 : 1.0,
             drawn_.onProcessor},
            volume::curvatureScale(volume_.grid().geometry(), field, noise, model.correlation, scaleMm)};
  }

  float depthNoise(const volume::HitEnclosure& hit, const volume::Ray& ray) const {
    const glm::dmat4& world = volume_.grid().geometry().worldFromVoxel;
    const auto point = volume::surfacePoint({volume_.grid(), hit.isovalue, inside_, data_},
                                            glm::dvec3(world * glm::dvec4(hit.voxel, 1.0)));
    if (!point) return kNone;
    const glm::dvec3 along = glm::normalize(glm::dmat3(world) * ray.direction);
    const double cosine = std::abs(glm::dot(point->normal, along));
    return cosine > 0.0 ? static_cast<float>(volume::offsetError(*point) / cosine) : kNone;
  }

  void judgeShape(std::size_t pixel, const volume::HitEnclosure& hit, std::span<const glm::dvec3> ends,
                  PictureErrors& out) const {
    const glm::dvec3 &shifted = hit.shifted, &deviation = hit.rounding.deviation;
    const volume::ShapeBound normal =
        volume::boundShape(normals_->shape, hit.voxel, shifted, ends, deviation);
    const volume::ShapeBound shape =
        normals_->scaled == curvature_->scaled
            ? normal
            : volume::boundShape(curvature_->shape, hit.voxel, shifted, ends, deviation);
    if (normal.at.normal != glm::dvec3(0.0)) {
      out.normalDegrees[pixel] = roundedUp(normal.normalDegrees);
      const double turn = kNoiseDeviationsOfPlane * normals_->noise.gradientNoise / normal.at.gradient;
      out.normalNoiseDegrees[pixel] = static_cast<float>(std::min(turn * 180.0 / std::numbers::pi, 180.0));
    }
    if (!shape.at.hasCurvature) return;
    out.curvature[pixel] = roundedUp(shape.curvature);
    out.curvatureNoise[pixel] =
        static_cast<float>(kNoiseDeviations * curvature_->noise.hessianNoise / shape.at.gradient);
    out.relativeCurvature[pixel] =
        static_cast<float>(shape.curvature / std::max({std::abs(shape.at.kappa1), std::abs(shape.at.kappa2),
                                                       curvature_->noise.flatCurvature}));
  }

  const volume::PreparedVolume& volume_;
  const DrawnHits& drawn_;
  scene::CameraFrame frame_;
  double aspect_;
  render::ViewUniforms view_;
  volume::PictureRays rays_;
  bool sampled_;
  std::vector<double> isovalues_;
  std::shared_ptr<const volume::CubicField> cubic_;
  volume::HitSource source_;
  std::vector<volume::HiddenOfSurface> hidden_;
  volume::SurfaceCut cut_;
  scene::Inside inside_;
  scene::NoiseModel data_;
  std::optional<volume::CutFaces> faces_;
  std::optional<ShapeFields> normals_, curvature_;
};

}  // namespace

PictureErrors pictureErrors(const volume::PreparedVolume& volume, const scene::Scene& scene,
                            const DrawnHits& drawn, base::Progress& progress) {
  ++runs;
  const std::size_t count = volume::Extent2{drawn.size}.count();
  PictureErrors out;
  out.size = drawn.size;
  out.certain.assign(count, 1);
  out.elsewhere.assign(count, 0);
  for (std::vector<float>* const image :
       {&out.depthMm, &out.normalDegrees, &out.curvature, &out.normalNoiseDegrees, &out.curvatureNoise,
        &out.depthNoiseMm, &out.relativeCurvature})
    image->assign(count, kNone);
  if (volume.grid().dims().x < 2 || volume.grid().dims().y < 2 || volume.grid().dims().z < 2) return out;

  const PictureEvaluator judge(volume, scene, drawn, progress);
  std::vector<double> fieldErrors(count, -1.0);  // -1: nothing is hit
  progress.report(0.0, "bounding errors");
  volume::parallelPieces(count, kPixelGrain, progress, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const volume::HitEnclosure hit = judge.enclose(i, 0.0);
      if (!hit.hit) continue;
      fieldErrors[i] = hit.fieldError;
      judge.judge(i, hit, out);
    }
  });
  // Rays that hit nothing may miss by less than a rounding.
  std::vector<double> known;
  std::ranges::copy_if(fieldErrors, std::back_inserter(known), [](double error) { return error >= 0.0; });
  const double usual = known.empty() ? 0.0 : base::quantile(known, kUsualError);
  volume::parallelPieces(count, kPixelGrain, progress, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool misses = fieldErrors[i] < 0.0;
      if (misses && (!std::isnan(drawn.depthMm[i]) || !judge.enclose(i, usual).certain))
        PictureEvaluator::refuse(i, out);
    }
  });
  return out;
}

std::size_t pictureErrorRuns() {
  return runs;
}

}  // namespace isolux::app
