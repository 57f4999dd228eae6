#include "app/surface_list/surface_list.h"

#include <algorithm>

#include "scene/rules/automatic.h"

namespace isolux::app {

namespace {

using scene::ExtraIsosurface;
using scene::Scene;

// What a CT has from this value on, HU.
struct Tissue {
  double from;
  const char* name;
  glm::dvec3 albedo;
};
constexpr Tissue kTissues[] = {{-950.0, "Lung", {0.72, 0.42, 0.38}},
                               {-400.0, "Skin", {0.78, 0.52, 0.40}},
                               {-30.0, "Soft tissue", {0.70, 0.30, 0.24}},
                               {150.0, "Bone", {0.82, 0.76, 0.62}},
                               {1500.0, "Enamel, metal", {0.86, 0.86, 0.84}}};

const Tissue* tissueAt(double hu) {
  const Tissue* best = nullptr;
  for (const Tissue& tissue : kTissues)
    if (hu >= tissue.from) best = &tissue;
  return best;
}

const ExtraIsosurface& unused(std::size_t place) {
  static const Scene scene;
  return scene.extraIsosurfaces[place];
}

bool isListed(const Scene& scene, std::size_t place) {
  return scene.extraIsosurfaces[place].shown || scene.extraIsosurfaces[place] != unused(place);
}

// Calls use(surface) of the surface with that number, whichever type it has.
template <class Use>
void withNumber(Scene& scene, int number, const Use& use) {
  if (number == 0)
    use(scene.isosurface);
  else
    use(scene.extraIsosurfaces.at(static_cast<std::size_t>(number - 1)));
}

// What lies in front of others is seen through, the rest is not; opacities that somebody chose stay.
void balance(Scene& scene, const scene::VolumeFacts& facts) {
  const Scene resolved = scene::resolve(scene, facts);
  std::vector<ListedSurface> there = listedSurfaces(scene, resolved);
  std::erase_if(there, [](const ListedSurface& surface) { return !surface.shown; });
  const double outward = scene.isosurface.inside == scene::Inside::above ? -1.0 : 1.0;
  for (const ListedSurface& surface : there) {
    if (surface.opacity < 1.0) continue;
    const bool inFront = std::ranges::any_of(
        there, [&](const ListedSurface& other) { return outward * (surface.value - other.value) > 0.0; });
    if (inFront && surface.facingOpacity == 1.0) setFacingOpacity(scene, surface.number, kSeeThrough);
    if (!inFront && surface.facingOpacity == kSeeThrough) setFacingOpacity(scene, surface.number, 1.0);
  }
}

}  // namespace

std::vector<ListedSurface> listedSurfaces(const Scene& scene, const Scene& resolved) {
  const scene::Isosurface& first = scene.isosurface;
  std::vector<ListedSurface> list = {{0, first.opacity > 0.0, first.name,
                                      resolved.isosurface.value.value_or(0.0), first.albedo, first.opacity,
                                      first.facingOpacity}};
  for (std::size_t i = 0; i < scene.extraIsosurfaces.size(); ++i) {
    const ExtraIsosurface& extra = scene.extraIsosurfaces[i];
    if (!isListed(scene, i)) continue;
    list.push_back({static_cast<int>(i) + 1, extra.shown, extra.name,
                    resolved.extraIsosurfaces[i].value.value_or(0.0), extra.albedo, extra.opacity,
                    extra.facingOpacity});
  }
  return list;
}

std::optional<Scene> withSurface(const Scene& scene, const volume::PreparedVolume& volume,
                                 std::optional<double> value) {
  for (std::size_t i = 0; i < scene.extraIsosurfaces.size(); ++i) {
    if (isListed(scene, i)) continue;
    Scene result = scene;
    ExtraIsosurface& added = result.extraIsosurfaces[i];
    added.shown = true;
    added.opacity = 1.0;
    added.value = value;
    // From now on it stays where it is, whatever becomes of the first.
    if (!value) added.value = scene::resolve(result, volume.facts).extraIsosurfaces[i].value;
    if (volume.kind.kind == scene::DataKind::ct_hu) {
      if (const Tissue* tissue = tissueAt(*added.value)) {
        added.name = tissue->name;
        added.albedo = tissue->albedo;
      }
    }
    balance(result, volume.facts);
    return result;
  }
  return std::nullopt;
}

Scene withoutSurface(const Scene& scene, const volume::PreparedVolume& volume, int number) {
  Scene result = scene;
  std::size_t goes = static_cast<std::size_t>(std::max(number - 1, 0));
  if (number == 0) {
    while (goes < scene.extraIsosurfaces.size() && !isListed(scene, goes)) ++goes;
    if (goes == scene.extraIsosurfaces.size()) return scene;
    const ExtraIsosurface& next = scene.extraIsosurfaces[goes];
    result.isosurface.name = next.name;
    result.isosurface.value = scene::resolve(scene, volume.facts).extraIsosurfaces[goes].value;
    result.isosurface.albedo = next.albedo;
    result.isosurface.opacity = next.shown ? next.opacity : 0.0;
    result.isosurface.facingOpacity = next.facingOpacity;
    result.isosurface.clipped = next.clipped;
  }
  result.extraIsosurfaces[goes] = unused(goes);
  balance(result, volume.facts);
  return result;
}

Scene withSurfaceShown(const Scene& scene, const volume::PreparedVolume& volume, int number, bool shown) {
  Scene result = scene;
  if (number == 0)
    result.isosurface.opacity = shown ? 1.0 : 0.0;
  else
    result.extraIsosurfaces.at(static_cast<std::size_t>(number - 1)).shown = shown;
  balance(result, volume.facts);
  // One that is hidden stays in the list.
  if (number > 0 && !shown && !isListed(result, static_cast<std::size_t>(number - 1)))
    setValue(
        result, number,
        *scene::resolve(scene, volume.facts).extraIsosurfaces[static_cast<std::size_t>(number - 1)].value);
  return result;
}

void setValue(Scene& scene, int number, double value) {
  withNumber(scene, number, [value](auto& surface) { surface.value = value; });
}

void setName(Scene& scene, int number, const std::string& name) {
  withNumber(scene, number, [&name](auto& surface) { surface.name = name; });
}

void setAlbedo(Scene& scene, int number, glm::dvec3 linear) {
  withNumber(scene, number, [linear](auto& surface) { surface.albedo = linear; });
}

void setOpacity(Scene& scene, int number, double opacity) {
  withNumber(scene, number, [opacity](auto& surface) { surface.opacity = opacity; });
}

void setFacingOpacity(Scene& scene, int number, double factor) {
  withNumber(scene, number, [factor](auto& surface) { surface.facingOpacity = factor; });
}

}  // namespace isolux::app
