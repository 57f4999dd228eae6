// Finds the exact first hit of each pixel's centre with all shown isosurfaces.
//
// Caps (volume/clip/cut_faces.h) occlude surfaces behind them and are not hits. Rays, camera and pixels are
// those of the renderer. Computes in double precision the first root in every cell (volume/hit/exact_hit.h,
// volume/hit/exact_cubic_hit.h) of the field hit.field, whatever hit.method is. Positions are voxel
// coordinates. Const members are safe from any thread.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/camera.h"
#include "volume/clip/cut_faces.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_hit.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::gi {

struct PrimaryHit {
  glm::dvec3 voxel{0.0};
  int surface = 0;    // index into surfaces()
  bool outer = true;  // the front face is visible
};

class PrimaryHits {
 public:
  struct Surface {
    double isovalue;  // data units
    glm::vec3 albedo;
    double specular = 0.0, roughness = 1.0;  // gi/sampling/gloss_lobe.h
  };

  // Throws Error{interrupted}.
  PrimaryHits(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& resolved,
              glm::ivec2 size, base::Progress& progress);

  std::optional<PrimaryHit> at(glm::ivec2 pixel) const;  // row 0 is the top row
  glm::vec3 direction(glm::ivec2 pixel) const;           // of the ray; unit, world
  // Returns the direction to look up in the environment: an orthographic view shows as much of it as a
  // perspective one.
  glm::vec3 backgroundDirection(glm::ivec2 pixel) const;
  const std::vector<Surface>& surfaces() const { return surfaces_; }
  // Returns the field for normals if the scene has a scale σ for them (derivatives.normal_scale), else null.
  const volume::ScaledField* normalField() const { return normalField_.get(); }

 private:
  glm::dvec2 ndcOf(glm::ivec2 pixel) const;
  std::optional<volume::RayHit> cast(double isovalue, volume::Ray ray) const;

  std::shared_ptr<const volume::PreparedVolume> volume_;
  glm::ivec2 size_;
  scene::CameraFrame frame_;
  glm::dmat4 voxelFromWorld_;
  double rayStartMm_ = 0.0;
  bool insideAbove_;
  scene::Field field_;
  std::vector<Surface> surfaces_;
  std::vector<volume::HiddenOfSurface> hidden_;
  volume::SurfaceCut cut_;
  std::optional<volume::CutFaces> faces_;            // if any are shown
  std::shared_ptr<const volume::CubicField> cubic_;  // of cubic fields
  std::shared_ptr<const volume::ScaledField> normalField_;
};

}  // namespace isolux::gi
