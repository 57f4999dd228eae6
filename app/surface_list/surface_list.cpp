#include "app/surface_list/surface_list.h"

#include <algorithm>
#include <iterator>

#include "scene/rules/automatic.h"
#include "scene/settings/scene_list.h"

namespace isolux::app {

namespace {

using scene::Scene;
using scene::Surface;

// What a CT has from this value on, HU.
struct Tissue {
  double from;
  const char* name;
  glm::dvec3 albedo;
};
constexpr double kLabelOpacity = 0.4;  // of labels that are taken out of the others
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

// What lies in front of others is seen through, the rest is not; opacities that somebody chose stay.
void balance(Scene& scene, const scene::VolumeFacts& facts) {
  if (facts.labelAlbedo) return;  // labels do not enclose one another
  const Scene resolved = scene::resolve(scene, facts);
  std::vector<ListedSurface> there = listedSurfaces(scene, resolved, nullptr);
  std::erase_if(there, [](const ListedSurface& surface) { return !surface.shown; });
  const double outward = scene.isosurface.inside == scene::Inside::above ? -1.0 : 1.0;
  for (const ListedSurface& surface : there) {
    if (surface.opacity < 1.0) continue;
    const bool inFront = std::ranges::any_of(
        there, [&](const ListedSurface& other) { return outward * (surface.value - other.value) > 0.0; });
    double& facing = scene.surfaces.at(static_cast<std::size_t>(surface.number)).facingOpacity;
    if (inFront && facing == 1.0) facing = kSeeThrough;
    if (!inFront && surface.facingOpacity == kSeeThrough) facing = 1.0;
  }
}

// Of each surface; empty where there are none, or a surface names what is none.
std::vector<std::vector<int>> labelsIn(const Scene& scene, const volume::PreparedVolume* volume) try {
  if (!volume || !volume->labels) return {};
  return volume::labelsOfSurfaces(scene, *volume->labels);
} catch (const base::Error&) {
  return {};
}

}  // namespace

std::vector<ListedSurface> listedSurfaces(const Scene& scene, const Scene& resolved,
                                          const volume::PreparedVolume* volume) {
  const std::vector<std::vector<int>> labels = labelsIn(scene, volume);
  std::vector<ListedSurface> list;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const Surface& of = scene.surfaces[i];
    // Scenes of before surfaces could be switched off hid the first by its opacity.
    const bool shown = of.shown && (i > 0 || of.opacity > 0.0);
    const bool isOfLabels =
        resolved.source.kind == scene::DataKind::labels && resolved.source.labels != scene::kLabelsAsValues;
    list.push_back({static_cast<int>(i), shown, of.name, resolved.surfaces[i].value.value_or(0.0), of.albedo,
                    of.opacity, of.facingOpacity, isOfLabels, of.labels});
    if (isOfLabels && of.labelColors && i < labels.size())
      list.back().albedo = volume::meanColor(*volume->labels, labels[i]);
  }
  return list;
}

std::optional<Scene> withSurface(const Scene& scene, const volume::PreparedVolume& volume,
                                 std::optional<double> value) {
  if (scene.surfaces.size() == scene::kSurfaces || volume.labels) return std::nullopt;
  Scene result = scene;
  Surface added = scene::newSurface(scene.surfaces.size());
  added.value = value;
  result.surfaces.push_back(added);
  // From now on it stays where it is, whatever becomes of the first.
  if (!value) added.value = scene::resolve(result, volume.facts).surfaces.back().value;
  if (volume.kind.kind == scene::DataKind::ct_hu) {
    if (const Tissue* tissue = tissueAt(*added.value)) {
      added.name = tissue->name;
      added.albedo = tissue->albedo;
    }
  }
  added.id = scene::newId(*scene::listOfPath("surfaces.order"), scene, added.name);
  result.surfaces.back() = added;
  balance(result, volume.facts);
  return result;
}

std::optional<Scene> withLabelSurface(const Scene& scene, const volume::PreparedVolume& volume,
                                      const std::vector<int>& labels) {
  const volume::ShownLabels& map = *volume.labels;
  Scene result = scene;
  for (Surface& surface : result.surfaces) {
    if (surface.labels.empty()) continue;
    std::vector<int> left;
    std::ranges::set_difference(volume::labelsNamed(surface.labels, *map.blocks, map.table.get()), labels,
                                std::back_inserter(left));
    surface.labels = volume::numbersOfLabels(left, *map.blocks);
    if (left.empty()) surface.id.clear();
  }
  std::erase_if(result.surfaces, [](const Surface& surface) { return surface.id.empty(); });
  if (result.surfaces.size() == scene::kSurfaces) return std::nullopt;
  Surface added = scene::newSurface(result.surfaces.size());
  added.labels = volume::numbersOfLabels(labels, *map.blocks);
  added.opacity = kLabelOpacity;
  if (labels.size() == 1) added.name = volume::labelName(map.table.get(), labels.front());
  result.surfaces.push_back(added);
  result.surfaces.back().id = scene::newId(*scene::listOfPath("surfaces.order"), scene, added.name);
  return result;
}

Scene withoutSurface(const Scene& scene, const volume::PreparedVolume& volume, int number) {
  if (scene.surfaces.size() == 1) return scene;
  Scene result = scene;
  if (number == 0) result.surfaces[1].value = scene::resolve(scene, volume.facts).surfaces[1].value;
  result.surfaces.erase(result.surfaces.begin() + number);
  balance(result, volume.facts);
  return result;
}

Scene withSurfaceMoved(const Scene& scene, const volume::PreparedVolume& volume, int from, int to) {
  Scene result = scene;
  if (!volume.labels) {
    const Scene resolved = scene::resolve(scene, volume.facts);
    for (std::size_t i = 0; i < result.surfaces.size(); ++i)
      result.surfaces[i].value = resolved.surfaces[i].value;
  }
  const auto first = result.surfaces.begin();
  if (from < to)
    std::rotate(first + from, first + from + 1, first + to + 1);
  else
    std::rotate(first + to, first + from, first + from + 1);
  return result;
}

Scene withSurfaceShown(const Scene& scene, const volume::PreparedVolume& volume, int number, bool shown) {
  Scene result = scene;
  Surface& surface = result.surfaces.at(static_cast<std::size_t>(number));
  surface.shown = shown;
  if (shown && surface.opacity == 0.0) surface.opacity = 1.0;
  balance(result, volume.facts);
  return result;
}

}  // namespace isolux::app
