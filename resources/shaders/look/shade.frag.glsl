// The look, in linear colour: base colour x light, lines over it, fog over all.
//
// LOOK, SHADING, TEXTURE, and the LOOK_..., SHADING_... and TEXTURE_... they are compared with: from the names of the
// settings' choices. MEASURE, MEASURE_SQUARE: colours stand for one number, or two. CURVATURE: kappas are bound; EDGE: offsets of
// edges, which colours stand for. SECOND: values of a second volume. LABELS: colours of labels. SHADOW,
// OCCLUSION, FLOW, FOG, ACCESSIBILITY, LINES: overlays. FACING: opacity depends on the angle of view. docs/explanation/looks.md has the formulas and sources.
#include "common.glsl"
#if LOOK == LOOK_DEPTH && !defined(FACING)
#define NO_GRADIENT
#endif
#include "surface.glsl"
#include "background.glsl"
#if defined(CURVATURE) || defined(EDGE) || defined(SECOND) || defined(CREVICES)
#include "color_row.glsl"
#endif
#ifdef LABELS
uniform sampler2D uLabel;  // the colour of the label at the surface point, and the label
#endif
#ifdef SECOND
#include "second_volume.glsl"
#endif
#if defined(CURVATURE) || defined(EDGE)
#include "measures.glsl"
#endif
#include "lighting.glsl"
#if OVERLAY != OVERLAY_NONE
#include "overlay.glsl"
#endif
#if TEXTURE != TEXTURE_NONE
#include "noise.glsl"
#include "solid_texture.glsl"
#endif

uniform vec2 uDepthRange;   // mm along the view direction: nearest and farthest corner of the volume
uniform vec3 uAlbedos[ALL_SURFACES];
uniform float uOpacities[ALL_SURFACES];
#ifdef FACING
uniform float uFacing[ALL_SURFACES];  // times opacity where the surface faces the viewer
#endif
uniform float uTextureScale;  // mm
#ifdef SHADOW
uniform sampler2D uLit;
uniform float uShadow;
#endif
#ifdef OCCLUSION
#include "occlusion.glsl"
#endif
#ifdef FLOW
uniform sampler2D uFlow;
uniform float uFlowStrength;
#endif
#ifdef ACCESSIBILITY
uniform float uAccessibility;
uniform float uHollow;  // curvature of the surface's hollows, 1/mm
#ifdef CREVICES
uniform sampler2D uCrevices;  // factors from the deepest hollow to the open surface, along a row
#endif
#endif
#ifdef LINES
uniform sampler2D uLines;  // coverage: ridges, valleys, suggestive contours, contours
uniform float uRidges, uContours, uSuggestiveContours;  // strengths
uniform vec3 uRidgeColor, uValleyColor, uContourColor;
#endif
uniform float uFog;
uniform vec3 uFogColor;
uniform vec3 uInnerTint;
layout(location = 0) out vec4 oColor;  // premultiplied by the surface's opacity; 0 where there is no surface

// How far through the volume, 0 .. 1.
float depthFraction(Point p) {
  return clamp((p.depth - uDepthRange.x) / max(uDepthRange.y - uDepthRange.x, 1e-30), 0.0, 1.0);
}

#ifdef ACCESSIBILITY
// Light and brushes reach pits least, valleys better, Hadwiger et al. 2005 fig. 9: darkened by how far both curvatures
// are negative, in parts of the surface's own.
float hollowness(vec4 kappa, float side) {
  vec2 inward = side > 0.0 ? -kappa.xy : kappa.yx;  // the inner side's hollows are the outer side's bumps
  float hollow = 0.4 * max(inward.x, 0.0) + 0.6 * max(inward.y, 0.0);
  hollow /= uHollow;
  return kappa.w * (1.0 - exp(-6.0 * hollow * hollow / (hollow + 0.12)));  // what is nearly flat stays bright
}
#endif

vec3 baseColor(Point p, vec3 albedo, vec4 kappa, ivec2 pixel) {
  vec3 base = albedo;
#ifdef LABELS
  vec4 label = texelFetch(uLabel, pixel, 0);
  if (label.x < 1e38) base = albedo = label.rgb;  // kNoValue: there is none
#endif
#ifdef EDGE
  base = edgeColor(pixel);
#elif defined(MEASURE) || defined(MEASURE_SQUARE)
  base = measureColor(kappa, texelFetch(uDirection, pixel, 0).w * uFlat, pixel);
#else
#if LOOK == LOOK_ACCESSIBILITY
  base = mix(albedo, vec3(1.0), 0.55);
#endif
#if TEXTURE != TEXTURE_NONE
  base = textured(base, p.position / uTextureScale,
                  p.footprint / (uTextureScale * max(-dot(p.normal, p.ray), 0.2)));
#endif
#ifdef SECOND
  base = withSecond(base, p, pixel);
#endif
  if (p.side < 0.0) base *= uInnerTint;
#endif
#ifdef ACCESSIBILITY
#ifdef CREVICES
  base *= mix(vec3(1.0), fromRow(uCrevices, 1.0 - hollowness(kappa, p.side)), uAccessibility);
#else
  base *= mix(vec3(1.0), vec3(0.10, 0.075, 0.06), uAccessibility * hollowness(kappa, p.side));
#endif
#endif
#ifdef FLOW
  base *= exp2(uFlowStrength * (1.1 * texelFetch(uFlow, pixel, 0).r - 0.1));
#endif
  return base;
}

// Lines lie over `color`; the result's w is how much of it they cover.
#ifdef LINES
vec4 withLines(vec3 color, ivec2 pixel) {
  vec4 lines = texelFetch(uLines, pixel, 0) * vec4(uRidges, uRidges, uSuggestiveContours, uContours);
  color = mix(color, uValleyColor, lines.y);
  color = mix(color, uRidgeColor, lines.x);
  color = mix(color, uContourColor, lines.z);
  color = mix(color, uContourColor, lines.w);
  return vec4(color, max(max(lines.x, lines.y), max(lines.z, lines.w)));
}
#endif

// Colour, and the part of it that is opaque whatever the surface's opacity.
vec4 shaded(ivec2 pixel, Point p, vec3 albedo) {
#if LOOK == LOOK_DEPTH
  // Even steps of depth are even steps of lightness.
  return vec4(vec3(pow(1.0 - 0.92 * depthFraction(p), 2.2)), 0.0);
#elif LOOK == LOOK_NORMAL
  return vec4(pow(p.outward * 0.5 + 0.5, vec3(2.2)), 0.0);
#elif LOOK == LOOK_CURVATURE_DIRECTION
  // A direction has no sign, and none at all where both curvatures are the same.
  vec3 along = texelFetch(uDirection, pixel, 0).xyz;  // in the tangent plane that is shown
  along = pow(abs(safeNormalize(along - dot(along, p.outward) * p.outward, along)), vec3(2.2));
  return vec4(mix(unknownColor, along, texelFetch(uKappa, pixel, 0).z), 0.0);
#else
  vec4 kappa = vec4(0.0);
#ifdef CURVATURE
  kappa = texelFetch(uKappa, pixel, 0);
#endif
  float lit = 1.0;
#ifdef SHADOW
  lit = mix(1.0, texelFetch(uLit, pixel, 0).r, uShadow);
#endif
  vec4 color = vec4(lighted(baseColor(p, albedo, kappa, pixel), p, lit), 0.0);
#ifdef OCCLUSION
  color.rgb *= opennessAt(p);
#endif
#if OVERLAY != OVERLAY_NONE
  color.rgb = withOverlay(color.rgb, p, pixel, texelFetch(uSurface, pixel, 0).xyz);
#endif
#ifdef LINES
  color = withLines(color.rgb, pixel);
#endif
#ifdef FOG
#ifdef FOG_BACKGROUND
  vec3 fogColor = backgroundAt(inPicture(fragment()).y / float(uPictureSize.y));
#else
  vec3 fogColor = uFogColor;
#endif
  color.rgb = mix(color.rgb, fogColor, uFog * depthFraction(p));
#endif
  return color;
#endif
}

// A pixel whose ray waits for a brick: hatched grey, like nothing that is a surface.
vec4 waiting() {
  vec2 at = inPicture(fragment());
  return vec4(vec3(mod(at.x + at.y, 12.0) < 6.0 ? 0.16 : 0.30), 1.0);
}

// scene/opacity.h
float opacityOf(int which, Point p) {
  float opacity = uOpacities[which];
#if defined(FACING) || SHADING == SHADING_GI
  float cosine = min(abs(dot(p.normal, p.ray)), 1.0);
#endif
#ifdef FACING
  opacity *= mix(uFacing[which], 1.0, (1.0 - cosine) * (1.0 - cosine));
#endif
#if SHADING == SHADING_GI
  if (opacity < 1.0) opacity = 1.0 - pow(1.0 - opacity, 1.0 / max(cosine, 0.01));
#endif
  return opacity;
}

void main() {
  ivec2 pixel = ivec2(fragment());
  vec4 surface = texelFetch(uSurface, pixel, 0);
  oColor = vec4(0.0);
  int known = int(texelFetch(uInfo, pixel, 0).g);
  if (waits(known)) oColor = waiting();
  if (surface.w < 0.0 || isJoined(known)) return;
  int which = surfaceOf(known);
  Point p = pointAt(pixel, surface);
  vec4 color = shaded(pixel, p, uAlbedos[which]);
  float opacity = mix(opacityOf(which, p), 1.0, color.w);
  const float largest = 60000.0;  // of half floats
  oColor = vec4(min(color.rgb, vec3(largest)), 1.0) * opacity;
}
