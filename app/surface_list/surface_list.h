// The surfaces of a scene as one list, of isovalues or of labels, and what adding, removing and showing one
// makes of the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// surfaces.ID.facing_opacity of a surface that lies in front of another.
constexpr double kSeeThrough = 0.15;

struct ListedSurface {
  int number = 0;  // its position, from 0
  bool shown = true;
  std::string name;    // empty: none was given
  double value = 0.0;  // data units
  glm::dvec3 albedo{0.5};
  double opacity = 1.0, facingOpacity = 1.0;
  bool isOfLabels = false;  // then, instead of a value:
  std::string labels;       // scene::Surface::labels
  bool operator==(const ListedSurface&) const = default;
};

// All surfaces. `resolved`: the same scene. `volume`: whose labels' colours are those of surfaces; null:
// none.
std::vector<ListedSurface> listedSurfaces(const scene::Scene& scene, const scene::Scene& resolved,
                                          const volume::PreparedVolume* volume);

// One more isosurface, opaque, at the end; without a value the automatic one. In Hounsfield units it is named
// and coloured for what lies there. Opaque surfaces that lie in front of another are seen through from now on
// (kSeeThrough), those that no longer do are not. None: there are
// kSurfaces, or the volume is a label map.
std::optional<scene::Scene> withSurface(const scene::Scene& scene, const volume::PreparedVolume& volume,
                                        std::optional<double> value);
// Those labels, ascending, as a surface of their own at the end, seen through. Surfaces that named them no
// longer do, and are removed where they named no other. None: there are kSurfaces. Requires that `volume`
// shows labels.
std::optional<scene::Scene> withLabelSurface(const scene::Scene& scene, const volume::PreparedVolume& volume,
                                             const std::vector<int>& labels);
// The same without it; the last one stays. An automatic isovalue of what is then the first stays what it was.
scene::Scene withoutSurface(const scene::Scene& scene, const volume::PreparedVolume& volume, int number);
// The same with the surface at another place; automatic isovalues stay what they were.
scene::Scene withSurfaceMoved(const scene::Scene& scene, const volume::PreparedVolume& volume, int from,
                              int to);
scene::Scene withSurfaceShown(const scene::Scene& scene, const volume::PreparedVolume& volume, int number,
                              bool shown);

}  // namespace isolux::app
