#include "scene/rules/automatic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scene/camera.h"
#include "scene/framing.h"
#include "scene/rules/needs.h"

namespace isolux::scene {

namespace {

constexpr double elevation = 0.21;  // radians (12 degrees): "slightly above"

// Of who looks at the front.
glm::dvec3 rightOf(WorldAxes axes) {
  return glm::cross(upOf(axes), frontOf(axes));
}

// In front of the volume, above it and to the viewer's left, each lamp a third of a turn further.
void resolveLamps(Scene& scene, const VolumeFacts& facts) {
  const glm::dvec3 center = 0.5 * (facts.boundsMinMm + facts.boundsMaxMm);
  const double size = std::max(glm::length(facts.boundsMaxMm - facts.boundsMinMm), 1e-9);
  for (std::size_t i = 0; i < scene.lamps.size(); ++i) {
    Lamp& lamp = scene.lamps[i];
    const double angle = (-0.65 + static_cast<double>(i) / 3.0 * 2.0) * std::numbers::pi;
    const glm::dvec3 toward = 0.7 * (std::cos(angle) * rightOf(facts.axes) -
                                     std::sin(angle) * frontOf(facts.axes) + upOf(facts.axes));
    if (!lamp.position) lamp.position = center + size * toward;
    if (!lamp.radius) lamp.radius = 0.1 * size;
  }
}

// Whether a surface shows what `values[i]` would: within a quarter of the way to the next.
bool isTaken(const std::vector<double>& values, std::size_t i, double range, double by) {
  double gap = 0.2 * range;
  if (i > 0 && by < values[i]) gap = values[i] - values[i - 1];
  if (i + 1 < values.size() && by > values[i]) gap = values[i + 1] - values[i];
  return std::abs(by - values[i]) <= 0.25 * gap;
}

// Where a further isosurface belongs: of the suggestions that nobody has, the next outside the first, else
// the next inside.
std::optional<double> nextSuggestion(const VolumeFacts& facts, double first, Inside inside,
                                     const std::vector<double>& taken) {
  const std::vector<double>& values = facts.suggestedIsovalues;
  const double outward = inside == Inside::above ? -1.0 : 1.0;
  const auto nearest = [&](double direction) -> std::optional<double> {
    std::optional<double> best;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool isFree = std::ranges::none_of(
          taken, [&](double by) { return isTaken(values, i, facts.maximum - facts.minimum, by); });
      const double distance = direction * (values[i] - first);
      if (isFree && distance > 0.0 && (!best || distance < direction * (*best - first))) best = values[i];
    }
    return best;
  };
  const std::optional<double> outside = nearest(outward);
  return outside ? outside : nearest(-outward);
}

void resolveFurther(Scene& scene, const VolumeFacts& facts) {
  const double first = *scene.surfaces.front().value;
  const bool above = scene.isosurface.inside == Inside::above;
  const double innermost = above ? std::max(facts.maximum, first) : std::min(facts.minimum, first);
  std::vector<double> taken = {first};
  for (std::size_t i = 1; i < scene.surfaces.size(); ++i)
    if (scene.surfaces[i].shown && scene.surfaces[i].value) taken.push_back(*scene.surfaces[i].value);
  for (std::size_t i = 1; i < scene.surfaces.size(); ++i) {
    Surface& further = scene.surfaces[i];
    if (further.value) continue;
    const double spread = std::lerp(first, innermost, static_cast<double>(i) / 4.0);
    further.value = nextSuggestion(facts, first, scene.isosurface.inside, taken).value_or(spread);
    if (further.shown) taken.push_back(*further.value);
  }
}

constexpr double kLabelNormalScale = 0.8;  // of the normals of labels: distances of slices

bool framesOutline(const Camera& camera, const VolumeFacts& facts) {
  return camera.frames == Frames::surface && !facts.outlineMm.empty();
}

}  // namespace

Camera framed(const Camera& camera, const VolumeFacts& facts) {
  return framesOutline(camera, facts) ? framing(camera, wholePicture(1.0), facts.outlineMm)
                                      : fitted(camera, facts.boundsMinMm, facts.boundsMaxMm);
}

Camera fittedTo(const Camera& camera, const VolumeFacts& facts, const std::function<Rooms()>& rooms) {
  if (!framesOutline(camera, facts)) return fittedTo(camera, facts.boundsMinMm, facts.boundsMaxMm, rooms);
  if (!camera.eye || !camera.target) return camera;
  const Camera square = framed(camera, facts);
  const double roundings = 1e-9 * glm::distance(*square.eye, *square.target);
  const bool chosen = !(glm::distance(*camera.eye, *square.eye) <= roundings &&
                        glm::distance(*camera.target, *square.target) <= roundings);
  return chosen ? camera : framing(camera, rooms(), facts.outlineMm);
}

Scene resolve(Scene scene, const VolumeFacts& facts) {
  if (!scene.surfaces.front().value) {
    const bool ofObject = scene.isosurface.suggestion == Suggestion::object;
    const double value = ofObject ? facts.suggestedIsovalue : facts.contrastIsovalue;
    scene.surfaces.front().value = std::isfinite(value) ? value : 0.0;
  }
  if (facts.labelAlbedo) {
    scene.source.kind = DataKind::labels;
    bool restIsTaken = false;  // all labels that no surface names are the first's that names none
    for (Surface& surface : scene.surfaces) {
      if (surface.labelColors) surface.albedo = *facts.labelAlbedo;
      surface.value = surface.value.value_or(0.0);
      if (!surface.labels.empty()) continue;
      if (restIsTaken) surface.shown = false;
      restIsTaken = true;
    }
    // Of slices that are far apart, traces are left on the surface; its shading does not show them.
    const auto [least, largest] = std::minmax({facts.spacingMm.x, facts.spacingMm.y, facts.spacingMm.z});
    if (!scene.derivatives.normalScale && largest > 1.5 * least)
      scene.derivatives.normalScale = kLabelNormalScale * largest;
  }
  if (!scene.source.csgValue) scene.source.csgValue = facts.csgIsovalue;

  resolveFurther(scene, facts);
  if (!scene.isosurface.albedoLow) scene.isosurface.albedoLow = facts.minimum;
  if (!scene.isosurface.albedoHigh) scene.isosurface.albedoHigh = facts.maximum;
  if (!scene.gi.band) {
    const double reach = 0.05 * (facts.maximum - facts.minimum);
    scene.gi.band = glm::dvec2(*scene.surfaces.front().value - reach, *scene.surfaces.front().value + reach);
  }
  resolveLamps(scene, facts);
  if (!scene.hit.nearThreshold) scene.hit.nearThreshold = facts.typicalStep / scene.hit.rate;
  if (!scene.look.contours) scene.look.contours = contoursOf(scene);
  if (!scene.look.occlusionRadius)
    scene.look.occlusionRadius = std::max(glm::length(facts.boundsMaxMm - facts.boundsMinMm) / 5.0, 1e-9);
  if (!scene.look.textureScale)
    scene.look.textureScale = std::max(0.1 * glm::length(facts.boundsMaxMm - facts.boundsMinMm), 1e-9);

  Camera& camera = scene.camera;
  if (camera.eye && camera.target && camera.up) return scene;

  // Along the chosen or else the default direction.
  const bool ofOutline = framesOutline(camera, facts);
  const glm::dvec3 up = ofOutline && !camera.eye ? facts.up : upOf(facts.axes), front = frontOf(facts.axes);
  Camera wanted = camera;
  if (!camera.eye) {
    wanted.target = glm::dvec3(0.0);
    wanted.eye = ofOutline ? facts.toEye : std::cos(elevation) * front + std::sin(elevation) * up;
    if (!camera.up) wanted.up = up;
  }
  const Camera fit = framed(wanted, facts);

  if (!camera.eye && camera.target)
    camera.eye = *fit.eye + (*camera.target - *fit.target);  // the same view, of another point
  if (!camera.eye) camera.eye = fit.eye;
  if (!camera.target) {
    camera.target = fit.target;
    // An eye that stands on the centre looks to the back, not nowhere.
    if (*camera.eye == *camera.target) camera.target = *camera.eye - front;
  }
  if (!camera.up) {
    const glm::dvec3 view = *camera.target - *camera.eye;
    const double along = glm::dot(view, up);
    const bool alongUp = glm::length(view - along * up) < 1e-3 * std::abs(along);
    camera.up = alongUp ? front : up;
  }
  return scene;
}

}  // namespace isolux::scene
