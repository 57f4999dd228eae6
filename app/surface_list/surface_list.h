// The isosurfaces of a scene as one list, and what adding, removing and showing one makes of the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

constexpr int kMostSurfaces = 1 + scene::kExtraIsosurfaces;
// isosurface.facing_opacity of a surface that lies in front of another.
constexpr double kSeeThrough = 0.15;

struct ListedSurface {
  int number = 0;  // 0: isosurface., 1: isosurface2. ...
  bool shown = true;
  std::string name;    // empty: none was given
  double value = 0.0;  // data units
  glm::dvec3 albedo{0.5};
  double opacity = 1.0, facingOpacity = 1.0;
  bool operator==(const ListedSurface&) const = default;
};

// The first, and those further ones that are shown or hold something that was set. `resolved`: the same
// scene.
std::vector<ListedSurface> listedSurfaces(const scene::Scene& scene, const scene::Scene& resolved);

// One more isosurface, opaque, in the first place that is free; without a value the automatic one. In
// Hounsfield units it is named and coloured for what lies there. Opaque surfaces that lie in front of another
// are seen through from now on (kSeeThrough), those that no longer do are not. None: all places are taken.
std::optional<scene::Scene> withSurface(const scene::Scene& scene, const volume::PreparedVolume& volume,
                                        std::optional<double> value);
// The same without it. Where the first goes, the next takes its place; the last one stays.
scene::Scene withoutSurface(const scene::Scene& scene, const volume::PreparedVolume& volume, int number);
// The first is hidden by an opacity of 0.
scene::Scene withSurfaceShown(const scene::Scene& scene, const volume::PreparedVolume& volume, int number,
                              bool shown);

void setValue(scene::Scene& scene, int number, double value);
void setName(scene::Scene& scene, int number, const std::string& name);
void setAlbedo(scene::Scene& scene, int number, glm::dvec3 linear);
void setOpacity(scene::Scene& scene, int number, double opacity);
void setFacingOpacity(scene::Scene& scene, int number, double factor);

}  // namespace isolux::app
