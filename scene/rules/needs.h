// Derives the inputs and contents of a scene's look from several settings.
//
// Pure functions of the Scene, resolved or not. Rules of relevance, passes of the renderer and the light all
// call them, so that they agree.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace isolux::scene {

// Returns whether the mode gives a colour that look.shading is applied to.
bool isColored(LookMode mode);
// Returns whether colours show numbers: of one dimension, or the (kappa1, kappa2) square of curvature_2d.
bool isMeasure(LookMode mode);
// Returns whether the look shows a raw quantity without shading and overlays.
bool isPlain(const Scene& scene);

// Returns the active shading: the mode's own, look.shading under modes that give a colour, else unlit.
Shading shadingOf(const Scene& scene);
// Returns whether surface points are lit by global illumination: baked, or unshadowed where nothing is baked.
bool usesGi(const Scene& scene);
// Returns the same scene under lights that need no baking, for frames before the light is baked.
Scene withoutGi(Scene scene);
// Returns whether the key light contributes to the image, so that its shadow is visible.
bool keyLightActs(const Scene& scene);
// Returns whether the key light's shadow is drawn.
bool showsShadow(const Scene& scene);
// Returns whether nearby geometry occludes light; it does for shadings that approximate large soft lights.
bool showsOcclusion(const Scene& scene);
// Returns the visible surfaces with gloss, in the order of their settings. There are none in looks without
// global illumination, and where colours show numbers.
struct GlossySurface {
  double specular = 0.0, roughness = 0.0;
};
std::vector<GlossySurface> glossySurfaces(const Scene& scene);
bool showsGloss(const Scene& scene);
// Returns whether streaks along the curvature are drawn.
bool showsFlow(const Scene& scene);
// Returns whether a second volume colours the surface.
bool showsSecondVolume(const Scene& scene);
// Returns whether the surface of a label map has the colours of its labels, in a resolved scene.
bool showsLabels(const Scene& scene);
bool showsLegend(const Scene& scene);
// Returns the strength of the silhouette: tone shading is designed for outlines (Gooch et al. 1998).
double contoursOf(const Scene& scene);
// Returns whether lines from curvature are drawn: ridges and valleys, silhouettes, suggestive contours.
bool drawsLines(const Scene& scene);

// Returns whether idle images may use hits of the interpolating B-spline instead of trilinear ones.
bool mayRefineHits(const Scene& scene);

bool needsGradient(const Scene& scene);
bool needsCurvature(const Scene& scene);
bool needsFlowline(const Scene& scene);  // the curvature of the gradient's flowlines
bool needsEdge(const Scene& scene);      // the distance of the object's edge from the surface
// Returns whether the look needs derivatives at derivatives.scale and their noise.
bool needsSecondDerivatives(const Scene& scene);

// Return the scales σ, mm, of the derivatives for curvature and for normals (derivatives.scale,
// derivatives.normal_scale). 0: none, by the setting, because the field has none, or because the automatic
// value is unknown yet.
double derivativesScale(const Scene& scene);
double normalScale(const Scene& scene);
// Return whether the look reads unscaled derivatives, and whether these use filtered fetches, which scaled
// ones do not have.
bool readsUnscaled(const Scene& scene);
bool fetchesFast(const Scene& scene);

// Return whether the scene has a clip plane, a clip box or a removed box; whether one clips a shown
// isosurface; and whether caps show values.
bool hasCuts(const Clip& clip);
bool cutsSurfaces(const Scene& scene);
bool showsCutFaces(const Scene& scene);

// Returns whether a surface is partly transparent. One of opacity 0 does not count.
bool isTransparent(const Scene& scene);

}  // namespace isolux::scene
