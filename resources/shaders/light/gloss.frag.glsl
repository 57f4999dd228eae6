// What a glossy surface reflects: the environment filtered by its lobe (gi/gloss/gloss_lobe.h) as far as it is seen,
// the surface itself, and the light sources. LAMP_COUNT: as in local_light.glsl.
#include "common.glsl"
#include "surface.glsl"
#include "local_light.glsl"

uniform vec4 uSpecular, uRoughness;  // of each surface
uniform vec4 uLayer;                 // the coordinate of each in uFiltered
uniform sampler3D uFiltered;         // gi/gloss/filtered_environment.h, a layer for each roughness
uniform mat3 uEnvironmentFromWorld;
uniform float uEnvironmentScale;
uniform sampler2D uReflected;  // of each cell: radiance of the surface; the part of the environment that is seen
uniform sampler2D uLampsSeen;  // the part of each lamp
uniform sampler2D uDepth;               // mm; -1: not traced
uniform ivec2 uFirstCell;
uniform float uCellSize;  // rays
layout(location = 0) out vec4 oGloss;  // R; F

const float kPi = 3.14159265;

// An octahedron unfolded to a square: no angles, and texels of about one size.
vec3 environment(vec3 world, float layer) {
  vec3 d = uEnvironmentFromWorld * world;
  d /= abs(d.x) + abs(d.y) + abs(d.z);
  vec2 at = d.z >= 0.0 ? d.xy : (1.0 - abs(d.yx)) * vec2(d.x >= 0.0 ? 1.0 : -1.0, d.y >= 0.0 ? 1.0 : -1.0);
  return uEnvironmentScale * textureLod(uFiltered, vec3(0.5 * at + 0.5, layer), 0.0).rgb;
}

float lobe(float exponent, float cosine) {
  return cosine > 0.0 ? (exponent + 1.0) / (2.0 * kPi) * pow(cosine, exponent) : 0.0;
}

// With the part of the lobe below the surface, which is mirrored up.
float lobes(float exponent, vec3 toward, vec3 mirror, vec3 normal) {
  float cosine = dot(toward, normal);
  if (!(cosine > 0.0)) return 0.0;
  return lobe(exponent, dot(toward, mirror)) + lobe(exponent, dot(toward - 2.0 * cosine * normal, mirror));
}

// From points over the disc that the lamp shows; the lobe is as much wider as they are apart.
vec3 lampLight(Lamp lamp, Point p, vec3 mirror, float exponent) {
  vec3 way = lamp.place.xyz - lamp.place.w * p.position;
  float range = max(length(way), 1e-30), sine = lamp.power.w / (lamp.place.w > 0.0 ? max(range, lamp.power.w) : 1.0);
  vec3 centre = way / range;
  vec3 light = lamp.power.rgb / (lamp.place.w > 0.0 ? max(range * range, lamp.power.w * lamp.power.w) : 1.0);
  if (!(sine > 0.0)) return light * lobes(exponent, centre, mirror, p.normal);
  const int kPoints = 16;
  float wider = 1.0 / (1.0 / (exponent + 1.0) + 0.25 * sine * sine / float(kPoints)) - 1.0;
  vec3 across = normalize(cross(centre, abs(centre.z) < 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  vec3 up = cross(centre, across);
  float sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    float part = (float(i) + 0.5) / float(kPoints), turn = 2.39996323 * float(i), radius = sine * sqrt(part);
    vec3 toward = sqrt(max(1.0 - radius * radius, 0.0)) * centre + radius * (cos(turn) * across + sin(turn) * up);
    sum += lobes(wider, toward, mirror, p.normal);
  }
  return light * sum / float(kPoints);
}

// The mean of the cells around that show the same piece of surface; the nearest, where none does.
void reflectedAt(Point p, out vec4 reflected, out vec3 seen) {
  vec2 at = inPicture(fragment()) / uCellSize - vec2(uFirstCell) - 0.5;
  ivec2 low = ivec2(floor(at)), last = textureSize(uReflected, 0) - 1;
  vec2 part = at - vec2(low);
  float tolerance = 4.0 * p.footprint * uCellSize, nearest = 3e37, sum = 0.0;
  reflected = vec4(0.0, 0.0, 0.0, 1.0);
  seen = vec3(1.0);
  vec4 reflections = vec4(0.0);
  vec3 sights = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1), cell = clamp(low + corner, ivec2(0), last);
    float depth = texelFetch(uDepth, cell, 0).r;
    if (depth < 0.0) continue;
    vec4 here = texelFetch(uReflected, cell, 0);
#if LAMP_COUNT > 0
    vec3 lamps = texelFetch(uLampsSeen, cell, 0).rgb;
#else
    vec3 lamps = vec3(1.0);
#endif
    float away = abs(depth - p.depth);
    if (away < nearest) {
      nearest = away;
      reflected = here;
      seen = lamps;
    }
    if (away > tolerance) continue;
    vec2 weights = mix(1.0 - part, part, vec2(corner));
    reflections += weights.x * weights.y * here;
    sights += weights.x * weights.y * lamps;
    sum += weights.x * weights.y;
  }
  if (sum > 1e-4) {
    reflected = reflections / sum;
    seen = sights / sum;
  }
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oGloss = vec4(0.0);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0) return;
  int which = int(texelFetch(uInfo, pixel, 0).g) & 3;
  float specular = uSpecular[which], roughness = uRoughness[which];
  Point p = pointAt(pixel, surface);
  if (!(specular > 0.0) || p.side < 0.0) return;
  float square = roughness * roughness, exponent = 0.5 / (square * square) - 0.5;
  float cosine = clamp(-dot(p.normal, p.ray), 0.0, 1.0), away = 1.0 - cosine;
  vec3 mirror = p.ray + 2.0 * cosine * p.normal, seen;
  vec4 reflected;
  reflectedAt(p, reflected, seen);
  vec3 radiance = reflected.a * environment(mirror, uLayer[which]) + reflected.rgb;
#if LAMP_COUNT > 0
  for (int i = 0; i < LAMP_COUNT; ++i) radiance += seen[i] * lampLight(uLamps[i], p, mirror, exponent);
#endif
  float steep = max(1.0 - roughness, specular) - specular;
  oGloss = vec4(clamp(radiance, 0.0, 60000.0), specular + steep * away * away * away * away * away);
}
