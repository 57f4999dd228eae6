// A view in double precision on the CPU, for any pair of fields: the yardstick of `isolux study`.
//
// Hits: volume::firstHitOfField(), every cell's first root. Shapes: gradient and Hessian of the
// derivatives' field, at their scales, at those hits: volume/field/reconstruct.h and curvature.h. Rays,
// camera and pixel centres are those of the renderer. Each pair of fields is computed once, spread over the
// threads by TBB.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "app/study/study_errors.h"
#include "base/progress.h"
#include "scene/camera.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_cubic_hit.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

class SurfaceReference {
 public:
  // `scene`: resolved; its camera, isovalue, sides and noise count.
  SurfaceReference(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& scene,
                   glm::ivec2 size);

  // Valid as long as this. Throws Error{interrupted}. Normals are at derivatives.normal_scale, curvature at
  // derivatives.scale; where they are empty, at 0.
  TrueSurface of(scene::Field hitField, const scene::Derivatives& derivatives, base::Progress& progress);

  // Hits alone. Valid as long as this. Throws Error{interrupted}.
  const std::vector<TrueHit>& hitsOf(scene::Field field, base::Progress& progress);

  // Whether the answer for this pixel hangs on a rounding: a ray or an isovalue as far off as single
  // precision cannot tell apart finds no crossing near the truth's, or one where it has none. After of()
  // with this field.
  bool undecided(scene::Field hitField, std::size_t pixel) const;

 private:
  static constexpr std::size_t kFields = 3;
  using Hits = std::vector<TrueHit>;
  using Shapes = std::vector<TrueShape>;

  volume::Ray rayOf(std::size_t pixel, glm::dvec2 offset = glm::dvec2(0.0)) const;
  volume::CubicHit cast(scene::Field field, const volume::Ray& ray, double isovalue) const;
  void prepare(scene::Field field, base::Progress& progress);
  TrueHit hitOf(scene::Field field, std::size_t pixel) const;
  struct ShapeSource {
    scene::Field field;
    std::shared_ptr<const volume::ScaledField> curvature, normals;  // null: at scale 0
    volume::CurvatureScale noise;
  };
  ShapeSource sourceOf(const scene::Derivatives& derivatives, base::Progress& progress);
  struct KnownSample {
    volume::FieldSample sample;
    bool known = true;
  };
  KnownSample sampleAt(scene::Field field, const volume::ScaledField* scaled, const glm::dvec3& voxel) const;
  TrueShape shapeAt(const ShapeSource& source, const glm::dvec3& voxel) const;

  std::shared_ptr<const volume::PreparedVolume> volume_;
  glm::ivec2 size_;
  scene::CameraFrame frame_;
  double rayStartMm_, isovalue_, outward_, noise_ = 0.0;
  glm::dvec3 noiseBlur_{0.0};
  std::array<std::shared_ptr<const volume::CubicField>, kFields>
      cubic_;  // of the cubic fields, once asked for
  std::array<Hits, kFields> hits_;
  // Of the hit's field, the shape's, scale and normal scale.
  std::map<std::tuple<scene::Field, scene::Field, double, double>, Shapes> shapes_;
};

}  // namespace isolux::app
