// Bounds of what a picture shows, pixel by pixel (volume/error): from where its rays hit and the volume, in
// double precision, spread over the threads by TBB.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "base/progress.h"
#include "gi/picture_light.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// A picture that was drawn, with one ray through the centre of each pixel.
struct ShownPicture {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;                             // as it was drawn
  std::shared_ptr<const gi::PictureLight> light;  // that it is lit by; null: none
  glm::ivec2 size{0};                             // pixels
};

// One ray through the centre of each pixel, row 0 at the top, as render::Aov::depth and voxel have them: NaN
// where there is no hit.
struct DrawnHits {
  glm::ivec2 size{0};
  std::vector<float> depthMm, voxel;  // voxel: x, y, z
  bool onProcessor = false;           // render::PassReport
};

// Row 0 at the top. Infinite where the answer is not certain; NaN where there is no surface, and where a
// surface has no normal or no curvature.
struct PictureErrors {
  glm::ivec2 size{0};
  std::vector<float> depthMm, normalDegrees, curvature;  // curvature: of kappa1 and kappa2, 1/mm
  // What noise makes of them beside, at kNoiseLevel of its distribution: of another scan of the same.
  std::vector<float> normalNoiseDegrees, curvatureNoise;
  // How far along the ray the object's own surface may be, by the noise of its samples and the distance
  // between them (volume::offsetError), mm: usually far more than arithmetic. NaN also where voxels are
  // missing nearby.
  std::vector<float> depthNoiseMm;
  std::vector<float>
      relativeCurvature;              // curvature / max(|kappa1|, |kappa2|, flat); volume/field/curvature.h
  std::vector<std::uint8_t> certain;  // 0 also where a ray misses a surface by no more than a rounding
  // 1 where the hit was drawn further away than arithmetic alone explains (samples at steps): its distance is
  // the bound there.
  std::vector<std::uint8_t> elsewhere;
  // Of E where light is stored, its largest channel (app/accuracy/light_bounds.h); empty where there is none.
  std::vector<float> light;
  double lightWithin = 0.0;     // the error of E that 95 % of the pixels do not exceed
  double meanIrradiance = 0.0;  // of the pixels that show it and their channels
};
inline constexpr double kNoiseLevel = 0.95;

// `scene`: as it was drawn, complete (app/ready/ready_fields.h, with images). Throws Error: interrupted;
// memory of fields that are not made yet.
PictureErrors pictureErrors(const volume::PreparedVolume& volume, const scene::Scene& scene,
                            const DrawnHits& drawn, base::Progress& progress);

// How often pictureErrors() has run in this process: nothing of it may run unasked.
std::size_t pictureErrorRuns();

}  // namespace isolux::app
