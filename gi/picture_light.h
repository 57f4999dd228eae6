// Stored light as a picture reads it: lattices, what they are multiplied with, and the local light that
// stands in where nothing is stored yet. Plain values; the lattices go on being filled while pictures are
// drawn.
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

// Of albedo * E / pi over points of the surface (gi/trace/exposure_meter.h), before the picture's exposure.
struct SurfaceBrightness {
  double median = 0.0, highlight = 0.0;  // luminance; highlight: 98 % of the points are darker
};

// Of one side of the surfaces.
struct StoredSide {
  // Either may be null: nothing stored of it.
  std::shared_ptr<const LightLattice> sky, lamps;
  // Of the isovalue that was shown before, which stand in for texels that are not lit yet. Irradiance; null
  // where there are none.
  std::shared_ptr<const LightLattice> skyBefore, lampsBefore;
  bool operator==(const StoredSide&) const = default;
};

struct PictureLight : StoredSide {  // its own: of the outer side
  StoredSide inner;                 // of the geometry and contents of the outer side's, once any is seen
  std::uint32_t samplesWanted = 100;
  glm::vec3 skyScale{1.0f};  // E = skyScale * stored: exposure, and the colour of a unit sky
  // Transfer: the environment's coefficients in the world's frame, windowed, with exposure; order^2 of rgb.
  std::vector<glm::vec3> environment;
  std::shared_ptr<const TransferBasis> basis;  // that transfer is compressed in; null until there is one

  // Unoccluded light, for texels that are not there yet: E(n) = sum of irradianceSh[i] Y_i(n), order 3, with
  // exposure; and the lamps without shadows.
  std::array<glm::vec3, 9> irradianceSh{};
  std::vector<LampLight> lampLights;
  float lampsIrradiance = 0.0f;  // of a surface in the middle of the volume that faces them all

  // The environment behind the surface.
  std::shared_ptr<const Environment> background;  // null: not shown
  glm::mat3 environmentFromWorld{1.0f};
  float backgroundScale = 1.0f;

  // Stops, where picture.exposure is automatic: by what is seen of the surface, else a white surface in the
  // open comes out nearly white.
  float automaticExposure = 0.0f;
  std::optional<SurfaceBrightness> seen;
  std::uint64_t version = 0;  // changes with anything above but the lattices' own revisions
};

// An environment in spherical harmonics, in its own frame: order^2 coefficients for transfer, nine for local
// light.
struct EnvironmentProjection {
  std::vector<glm::dvec3> transfer, local;
};
EnvironmentProjection projectEnvironment(const Environment& environment, int order);

// All but the lattices, the basis, the version and what is seen: the exposure is by the lights.
// `light.environment` must not be null.
PictureLight makePictureLight(const scene::Scene& resolved, const LightScene& light,
                              const EnvironmentProjection& projection);

}  // namespace isolux::gi
