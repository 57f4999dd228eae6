// The background behind what is shaded; supersamples averaged in linear light. LINEAR: as that is; otherwise each
// through the tone curve (FILMIC: of what is shaded and of a visible environment) and at most 1, encoded as sRGB, with a dither of one step against banding. NOTHING_ELSE: the background alone. CUT_FACES:
// faces that cuts lay open are before it. GROUND: it is darkened by the shadow on the ground, which with TRANSPARENT is
// black and covers as much as it darkens. TRANSPARENT: nothing is behind; straight alpha, with LINEAR premultiplied.
#include "background.glsl"
#ifdef ENVIRONMENT
#include "environment.glsl"
#endif
#ifdef GROUND
#include "ground.glsl"
#endif
#ifdef FILMIC
#include "tone_curve.glsl"
#endif
#ifdef CUT_FACES
#include "color_row.glsl"
uniform sampler2D uCutFaces;   // t (-1: none) and value of the cut face behind all that is shaded
uniform sampler2D uCutColors;  // black to white
uniform vec2 uCutWindow;       // level and width
uniform int uCutOfLabels;      // 1: values are colours, 8 bits of the root of each channel
vec3 faceColor(float value) {
  if (uCutOfLabels != 0) {
    int bytes = int(value);
    vec3 roots = vec3(bytes >> 16, bytes >> 8 & 255, bytes & 255) / 255.0;
    return roots * roots;
  }
  float grey = uCutWindow.y > 0.0 ? (value - uCutWindow.x) / uCutWindow.y + 0.5 : float(value >= uCutWindow.x);
  return fromRow(uCutColors, clamp(grey, 0.0, 1.0));
}
#endif
#ifndef NOTHING_ELSE
uniform sampler2D uColor;  // premultiplied; elsewhere nothing is
uniform ivec2 uColorLow;   // its first ray within what is drawn
#endif
uniform int uSupersampling;
uniform ivec2 uTileOrigin;   // pixels
uniform ivec2 uPictureSize;  // pixels, of the whole picture
layout(location = 0) out vec4 oPicture;

vec3 encoded(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

// A hash of the pixel in [0, 1): the same picture every time.
float noise(uvec2 p) {
  uint h = p.x * 0x9E3779B1u ^ p.y * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return float((h ^ (h >> 15)) >> 8) / 16777216.0;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef TRANSPARENT
  vec4 covered = vec4(0.0);  // premultiplied
#else
  vec3 sum = vec3(0.0);
#endif
  ivec2 rays = uPictureSize * uSupersampling;
  for (int y = 0; y < uSupersampling; ++y)
    for (int x = 0; x < uSupersampling; ++x) {
      ivec2 ray = pixel * uSupersampling + ivec2(x, y);
#ifdef NOTHING_ELSE
      vec4 color = vec4(0.0);
#else
      ivec2 at = ray - uColorLow;
      bool within = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(uColor, 0)));
      vec4 color = within ? texelFetch(uColor, at, 0) : vec4(0.0);
#ifdef FILMIC
      if (color.a > 0.0) color.rgb = filmic(color.rgb / color.a) * color.a;
#endif
#endif
#ifdef CUT_FACES
      vec2 face = texelFetch(uCutFaces, ray, 0).rg;
#endif
      ray += uTileOrigin * uSupersampling;
#ifdef TRANSPARENT
#ifdef CUT_FACES
      if (face.x >= 0.0) color = vec4(color.rgb + (1.0 - color.a) * faceColor(face.y), 1.0);
#endif
#ifndef LINEAR
      color.rgb = min(color.rgb, vec3(color.a));  // as bright as white, where it covers
#endif
#ifdef GROUND
      color.a += (1.0 - color.a) * (1.0 - groundAt((vec2(ray) + 0.5) / vec2(rays)));
#endif
      covered += color;
    }
  covered /= float(uSupersampling * uSupersampling);
#ifdef LINEAR
  oPicture = covered;
#else
  float dither = (noise(uvec2(pixel + uTileOrigin)) - 0.5) / 255.0;
  oPicture = covered.a > 0.0 ? vec4(encoded(covered.rgb / covered.a) + dither, covered.a) : vec4(0.0);
#endif
#else
#ifdef ENVIRONMENT
      vec3 behind = environmentAt((vec2(ray) + 0.5) / vec2(rays));
#else
      vec3 behind = backgroundAt((float(ray.y) + 0.5) / float(rays.y));
#endif
#ifdef GROUND
      behind *= groundAt((vec2(ray) + 0.5) / vec2(rays));
#endif
#if defined(ENVIRONMENT) && defined(FILMIC)
      behind = filmic(behind);
#endif
#ifdef CUT_FACES
      if (face.x >= 0.0) behind = faceColor(face.y);
#endif
      vec3 seen = color.rgb + (1.0 - color.a) * behind;
#ifdef LINEAR
      sum += seen;
    }
  oPicture = vec4(sum / float(uSupersampling * uSupersampling), 1.0);
#else
      sum += min(seen, vec3(1.0));
    }
  float dither = (noise(uvec2(pixel + uTileOrigin)) - 0.5) / 255.0;
  oPicture = vec4(encoded(sum / float(uSupersampling * uSupersampling)) + dither, 1.0);
#endif
#endif
}
