// What a glossy surface reflects: the environment filtered by its lobe (gi/sampling/gloss_lobe.h) as far as it is seen,
// the surface itself, and the light sources. Needs surface.glsl. LAMP_COUNT: as in local_light.glsl.
#include "local_light.glsl"

uniform float uReflectance[ALL_SURFACES], uRoughness[ALL_SURFACES], uFilteredLayer[ALL_SURFACES];
uniform sampler2D uFiltered;  // gi/gloss/filtered_environment.h, a square for each roughness, one above the other
uniform mat3 uGlossFromWorld;  // to the environment
uniform float uGlossScale;     // of the environment
uniform sampler2D uReflected;  // of each cell: radiance of the surface; the part of the environment that is seen
uniform sampler2D uLampsSeen;  // the part of each lamp
uniform sampler2D uCellDepth;  // mm; -1: not traced
uniform ivec2 uFirstCell;
uniform float uCellSize;  // rays

const float kPi = 3.14159265;

// An octahedron unfolded to a square: no angles, and texels of about one size.
vec3 environment(vec3 world, float layer) {
  vec3 d = uGlossFromWorld * world;
  d /= abs(d.x) + abs(d.y) + abs(d.z);
  vec2 at = d.z >= 0.0 ? d.xy : (1.0 - abs(d.yx)) * vec2(d.x >= 0.0 ? 1.0 : -1.0, d.y >= 0.0 ? 1.0 : -1.0);
  vec2 size = vec2(textureSize(uFiltered, 0));
  float row = clamp((0.5 * at.y + 0.5) * size.x, 0.5, size.x - 0.5) + layer * size.x;  // not of the next square
  return uGlossScale * textureLod(uFiltered, vec2(0.5 * at.x + 0.5, row / size.y), 0.0).rgb;
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

// The mean of the cells around that show the same piece of surface; the nearest in depth, where none does.
void reflectedAt(Point p, out vec4 reflected, out vec3 seen) {
  vec2 at = inPicture(fragment()) / uCellSize - vec2(uFirstCell) - 0.5;
  ivec2 low = ivec2(floor(at)), last = textureSize(uReflected, 0) - 1;
  ivec4 cells = ivec4(clamp(low, ivec2(0), last), clamp(low + 1, ivec2(0), last));
  ivec2 corners[4] = ivec2[4](cells.xy, cells.zy, cells.xw, cells.zw);
  vec4 depths;
  for (int i = 0; i < 4; ++i) depths[i] = texelFetch(uCellDepth, corners[i], 0).r;
  vec4 away = mix(abs(depths - p.depth), vec4(3e37), lessThan(depths, vec4(0.0)));
  vec2 part = at - vec2(low);
  vec4 weights = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(vec2(1.0 - part.y), vec2(part.y));
  float facing = max(-dot(p.normal, p.ray), 0.05);
  weights *= step(away, vec4(4.0 * p.footprint * uCellSize / facing));
  float sum = dot(weights, vec4(1.0));
  if (!(sum > 1e-4)) {
    float nearest = min(min(away.x, away.y), min(away.z, away.w));
    weights = step(away, vec4(nearest));
    sum = dot(weights, vec4(1.0));
  }
  weights /= sum;
  reflected = vec4(0.0);
  seen = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    reflected += weights[i] * texelFetch(uReflected, corners[i], 0);
#if LAMP_COUNT > 0
    seen += weights[i] * texelFetch(uLampsSeen, corners[i], 0).rgb;
#endif
  }
}

// R; F.
vec4 glossAt(Point p, int which) {
  float specular = uReflectance[which], roughness = uRoughness[which];
  if (!(specular > 0.0) || p.side < 0.0) return vec4(0.0);
  float square = roughness * roughness, exponent = 0.5 / (square * square) - 0.5;
  float cosine = clamp(-dot(p.normal, p.ray), 0.0, 1.0), away = 1.0 - cosine;
  vec3 mirror = p.ray + 2.0 * cosine * p.normal, seen;
  vec4 reflected;
  reflectedAt(p, reflected, seen);
  vec3 radiance = reflected.a * environment(mirror, uFilteredLayer[which]) + reflected.rgb;
#if LAMP_COUNT > 0
  for (int i = 0; i < LAMP_COUNT; ++i) radiance += seen[i] * lampLight(uLamps[i], p, mirror, exponent);
#endif
  float steep = max(1.0 - roughness, specular) - specular;
  return vec4(radiance, specular + steep * away * away * away * away * away);
}
