#include "scene/rules/needs.h"

namespace isolux::scene {

bool isColored(LookMode mode) {
  return mode >= LookMode::kappa1 && mode <= LookMode::flow;
}

bool isMeasure(LookMode mode) {
  return mode >= LookMode::kappa1 && mode <= LookMode::curvature_2d;
}

bool isPlain(const Scene& scene) {
  return scene.look.mode == LookMode::normal || scene.look.mode == LookMode::depth;
}

Shading shadingOf(const Scene& scene) {
  switch (scene.look.mode) {
    case LookMode::blinn_phong:
      return Shading::blinn_phong;
    case LookMode::lambert:
      return Shading::lambert;
    case LookMode::tone:
      return Shading::tone;
    case LookMode::gi:
      return Shading::gi;
    default:
      return isColored(scene.look.mode) ? scene.look.shading : Shading::unlit;
  }
}

bool usesGi(const Scene& scene) {
  return shadingOf(scene) == Shading::gi;
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

bool showsFlow(const Scene& scene) {
  return scene.look.mode == LookMode::flow || (!isPlain(scene) && scene.flow.strength > 0.0);
}

bool showsLegend(const Scene& scene) {
  return scene.look.legend && isMeasure(scene.look.mode);
}

bool needsGradient(const Scene& scene) {
  return scene.look.mode != LookMode::depth;
}

bool needsCurvature(const Scene& scene) {
  const Look& look = scene.look;
  if (isPlain(scene)) return false;
  return isColored(look.mode) || look.accessibility > 0.0 || look.ridges > 0.0 || look.contours > 0.0 ||
         look.suggestiveContours > 0.0 || showsFlow(scene);
}

bool isTransparent(const Scene& scene) {
  const auto between = [](double opacity) { return opacity > 0.0 && opacity < 1.0; };
  if (between(scene.isosurface.opacity)) return true;
  for (const ExtraIsosurface* extra : {&scene.isosurface2, &scene.isosurface3, &scene.isosurface4})
    if (extra->shown && between(extra->opacity)) return true;
  return false;
}

}  // namespace isolux::scene
