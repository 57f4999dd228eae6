// What a scene's look needs and shows: facts that follow from several settings at once.
//
// Pure functions of the Scene, resolved or not. Rules of relevance, passes of the renderer and the light all
// ask here, so that they agree.
#pragma once

#include "scene/scene.h"

namespace isolux::scene {

// The mode gives a colour that a shading is laid over.
bool isColored(LookMode mode);
// Colours stand for numbers: of one dimension, or the (kappa1, kappa2) square of curvature_2d.
bool isMeasure(LookMode mode);
// Shows a raw quantity, with nothing laid over it.
bool isPlain(const Scene& scene);

// The shading that applies: the mode's own, look.shading under modes that give a colour, else unlit.
Shading shadingOf(const Scene& scene);
// Light of the surface points comes from global illumination: stored, or local where nothing is.
bool usesGi(const Scene& scene);
// Whether the key light brightens anything, so that its shadow is seen.
bool keyLightActs(const Scene& scene);
// Whether the key light's shadow is drawn.
bool showsShadow(const Scene& scene);
// Whether what stands near keeps light away: it does from large soft lights, which these shadings stand for.
bool showsOcclusion(const Scene& scene);
// Whether streaks along the curvature are drawn.
bool showsFlow(const Scene& scene);
// Whether a second volume colours the surface.
bool showsSecondVolume(const Scene& scene);
bool showsLegend(const Scene& scene);
// Strength of the silhouette: tone shading is meant to be seen with outlines (Gooch et al. 1998).
double contoursOf(const Scene& scene);
// Some line that curvature says where to draw: ridges and valleys, silhouettes, suggestive contours.
bool drawsLines(const Scene& scene);

// Pictures at rest may take hits of the B-spline through the samples instead of trilinear ones.
bool mayRefineHits(const Scene& scene);

bool needsGradient(const Scene& scene);
bool needsCurvature(const Scene& scene);
bool needsEdge(const Scene& scene);  // how far the object's edge lies from the surface
// Derivatives at derivatives.scale, and the noise they are judged by.
bool needsSecondDerivatives(const Scene& scene);

// Scales, mm, of the derivatives that curvature comes from and of those that normals are made of
// (derivatives.scale, derivatives.normal_scale). 0: none, by the setting, because the field has none, or
// because what is automatic is not known yet.
double derivativesScale(const Scene& scene);
double normalScale(const Scene& scene);
// The look reads derivatives at no scale; and those are made of filtered fetches, which a scale has not.
bool readsUnscaled(const Scene& scene);
bool fetchesFast(const Scene& scene);

// There is a plane or a box to cut with; it cuts an isosurface that is shown; and the faces that it lays open
// show values.
bool hasCuts(const Clip& clip);
bool cutsSurfaces(const Scene& scene);
bool showsCutFaces(const Scene& scene);

// Some surface lets through what lies behind it. One of opacity 0 is not there.
bool isTransparent(const Scene& scene);

}  // namespace isolux::scene
