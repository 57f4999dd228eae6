#include "scene/rules/needs.h"

#include <algorithm>
#include <functional>

#include "scene/looks.h"
#include "scene/opacity.h"
#include "scene/shown_surfaces.h"

namespace isolux::scene {

bool isColored(LookMode mode) {
  const LookKind kind = lookInfo(mode).kind;
  return kind != LookKind::shading && kind != LookKind::raw;
}

bool isMeasure(LookMode mode) {
  const LookKind kind = lookInfo(mode).kind;
  return kind == LookKind::measure || kind == LookKind::square;
}

bool isPlain(const Scene& scene) {
  return lookInfo(scene.look.mode).kind == LookKind::raw;
}

Shading shadingOf(const Scene& scene) {
  return isColored(scene.look.mode) ? scene.look.shading : lookInfo(scene.look.mode).shading;
}

bool usesGi(const Scene& scene) {
  return shadingOf(scene) == Shading::gi;
}

Scene withoutGi(Scene scene) {
  if (scene.look.mode == LookMode::gi) scene.look.mode = LookMode::blinn_phong;
  if (scene.look.shading == Shading::gi) scene.look.shading = Shading::lambert;
  return scene;
}

bool keyLightActs(const Scene& scene) {
  const Shading shading = shadingOf(scene);
  if (shading == Shading::tone) return true;  // by its direction alone
  if (shading == Shading::unlit || shading == Shading::gi) return false;
  const glm::dvec3& color = scene.light.color;
  const bool shines = scene.light.intensity > 0.0 && (color.r > 0.0 || color.g > 0.0 || color.b > 0.0);
  const bool highlight = shading == Shading::blinn_phong && scene.look.specular > 0.0;
  return shines && (scene.look.ambient < 1.0 || highlight);
}

bool showsShadow(const Scene& scene) {
  return scene.look.shadow > 0.0 && keyLightActs(scene);
}

bool showsOcclusion(const Scene& scene) {
  const Shading shading = shadingOf(scene);
  return scene.look.occlusion > 0.0 && scene.light.setup == LightSetup::three_point &&
         (shading == Shading::lambert || shading == Shading::blinn_phong);
}

std::vector<GlossySurface> glossySurfaces(const Scene& scene) {
  std::vector<GlossySurface> list;
  if (!usesGi(scene) || isMeasure(scene.look.mode)) return list;
  for (const Surface& surface : visibleSurfaces(scene))
    if (surface.specular > 0.0) list.push_back({surface.specular, surface.roughness});
  return list;
}

bool showsGloss(const Scene& scene) {
  return !glossySurfaces(scene).empty();
}

bool showsFlow(const Scene& scene) {
  return scene.look.mode == LookMode::flow || (!isPlain(scene) && scene.flow.strength > 0.0);
}

bool showsSecondVolume(const Scene& scene) {
  const ColorVolume& color = scene.color;
  return !color.volume.empty() && (color.strength > 0.0 || color.isolines > 0.0) && !isPlain(scene) &&
         !isMeasure(scene.look.mode);
}

bool showsLabels(const Scene& scene) {
  return scene.source.kind == DataKind::labels && !isPlain(scene) && !isMeasure(scene.look.mode);
}

bool showsLegend(const Scene& scene) {
  return scene.look.legend && (isMeasure(scene.look.mode) || showsSecondVolume(scene));
}

bool mayRefineHits(const Scene& scene) {
  const Hit& hit = scene.hit;
  return scene.picture.restHits != StillField::same && hit.method == HitMethod::exact &&
         hit.field == Field::trilinear && !usesGi(scene);
}

double contoursOf(const Scene& scene) {
  return scene.look.contours.value_or(shadingOf(scene) == Shading::tone ? 0.5 : 0.0);
}

bool drawsLines(const Scene& scene) {
  const Look& look = scene.look;
  return !isPlain(scene) && (look.ridges > 0.0 || contoursOf(scene) > 0.0 || look.suggestiveContours > 0.0);
}

bool needsGradient(const Scene& scene) {
  return lookInfo(scene.look.mode).readsGradient || variesByAngle(scene);
}

bool needsCurvature(const Scene& scene) {
  const Look& look = scene.look;
  if (isPlain(scene)) return lookInfo(look.mode).readsCurvature;
  return lookInfo(look.mode).readsCurvature || look.accessibility > 0.0 || drawsLines(scene) ||
         showsFlow(scene);
}

bool needsFlowline(const Scene& scene) {
  return lookInfo(scene.look.mode).readsFlowline;
}

bool needsEdge(const Scene& scene) {
  return lookInfo(scene.look.mode).readsEdge;
}

bool needsSecondDerivatives(const Scene& scene) {
  return needsCurvature(scene) || needsEdge(scene);
}

double derivativesScale(const Scene& scene) {
  return scene.derivatives.field == Field::trilinear ? 0.0 : scene.derivatives.scale.value_or(0.0);
}

double normalScale(const Scene& scene) {
  return scene.derivatives.field == Field::trilinear ? 0.0 : scene.derivatives.normalScale.value_or(0.0);
}

bool readsUnscaled(const Scene& scene) {
  return (needsGradient(scene) && normalScale(scene) == 0.0) ||
         (needsCurvature(scene) && derivativesScale(scene) == 0.0);
}

bool fetchesFast(const Scene& scene) {
  return scene.derivatives.fetch == Fetch::fast && scene.derivatives.field != Field::trilinear &&
         readsUnscaled(scene);
}

bool hasCuts(const Clip& clip) {
  return !clip.planes.empty() || !clip.box.empty() || !clip.removed.empty();
}

bool cutsSurfaces(const Scene& scene) {
  return hasCuts(scene.clip) && std::ranges::any_of(shownSurfaces(scene), std::identity{}, &Surface::clipped);
}

bool showsCutFaces(const Scene& scene) {
  return scene.clip.cap != ClipCap::none && cutsSurfaces(scene);
}

bool isTransparent(const Scene& scene) {
  return std::ranges::any_of(shownSurfaces(scene), isSeenThrough<Surface>);
}

}  // namespace isolux::scene
