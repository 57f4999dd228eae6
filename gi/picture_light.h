// Describes baked lighting as a frame reads it: the lattices, their factors, and the unshadowed direct
// lighting used where nothing is baked yet. Plain values; a bake may go on filling the lattices while frames
// are drawn.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "gi/harmonics/transfer_basis.h"
#include "gi/lattice/light_lattice.h"
#include "gi/light_scene.h"
#include "gi/sampling/environment.h"

namespace isolux::gi {

struct GlossLight;    // gi/gloss/reflections.h
struct GroundShadow;  // gi/ground/ground_shadow.h

// Statistics of E / pi times a fixed reflectance over points of the surface (gi/trace/exposure_meter.h),
// before the image's exposure.
struct SurfaceBrightness {
  double median = 0.0, highlight = 0.0;  // luminance; highlight: the 98 % quantile
};

// Baked lighting of one side of the surfaces.
struct StoredSide {
  // Either is null if nothing is baked of it.
  std::shared_ptr<const LightLattice> sky, lamps;
  // Irradiance of the isovalue shown before, used for texels that are not lit yet; may be null.
  std::shared_ptr<const LightLattice> skyBefore, lampsBefore;
  bool operator==(const StoredSide&) const = default;
};

struct PictureLight : StoredSide {           // the base: of the front faces
  std::shared_ptr<const volume::Grid> grid;  // that it is baked in; null: that of the volume drawn
  StoredSide inner;  // of the back faces, with the same geometry and contents, once any is visible
  std::uint32_t samplesWanted = 100;
  glm::vec3 skyScale{1.0f};  // E = skyScale * stored: exposure, and the colour of a unit sky
  // Transfer: the environment's SH coefficients in the world frame, windowed, with exposure; order^2 of RGB.
  std::vector<glm::vec3> environment;
  std::shared_ptr<const TransferBasis> basis;  // that transfer is compressed in; null until it exists

  // Unoccluded irradiance, for texels that are not lit yet: E(n) = sum of irradianceSh[i] Y_i(n), order 3,
  // with exposure; and the light sources without shadows.
  std::array<glm::vec3, 9> irradianceSh{};
  std::vector<LampLight> lampLights;
  float lampsIrradiance = 0.0f;  // of a surface at the volume's centre that faces them all

  std::shared_ptr<const GlossLight> gloss;     // null: no surface is glossy
  std::shared_ptr<const GroundShadow> ground;  // null: the scene has no ground

  // The environment shown as the background.
  std::shared_ptr<const Environment> background;  // null: not shown
  glm::mat3 environmentFromWorld{1.0f};
  float backgroundScale = 1.0f;

  // Stops, used if picture.exposure is automatic. Depends on the visible surface; if that is unknown, an
  // unoccluded white surface appears nearly white.
  float automaticExposure = 0.0f;
  std::optional<SurfaceBrightness> seen;
  std::uint64_t version = 0;  // changes with any member above except the lattices' own revisions
};

// An environment in spherical harmonics, in its own frame: order^2 coefficients for transfer, nine for
// unshadowed direct lighting.
struct EnvironmentProjection {
  std::vector<glm::dvec3> transfer, local;
};
EnvironmentProjection projectEnvironment(const Environment& environment, int order);

// Fills in all but the lattices, the basis, gloss, the ground, the version and the visible brightness; the
// exposure is that of the lights. Requires that `light.environment` is not null.
PictureLight makePictureLight(const scene::Scene& resolved, const LightScene& light,
                              const EnvironmentProjection& projection);

}  // namespace isolux::gi
