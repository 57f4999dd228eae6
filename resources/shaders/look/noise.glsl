// Value noise over the integer lattice: the same on every machine, no textures.

// PCG hash in three dimensions, Jarzynski & Olano, "Hash functions for GPU rendering", 2020; one of its outputs.
float latticeValue(ivec3 cell) {
  uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  return float(v.x >> 8) * (1.0 / 16777216.0);
}

// In [0, 1), mean 1/2, smooth; features of size 1. Standard deviation over all p: valueNoiseDeviation.
const float valueNoiseDeviation = 0.178;
float valueNoise(vec3 p) {
  vec3 base = floor(p);
  ivec3 cell = ivec3(base);
  vec3 f = p - base;
  f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec4 low = vec4(latticeValue(cell), latticeValue(cell + ivec3(1, 0, 0)), latticeValue(cell + ivec3(0, 1, 0)),
                  latticeValue(cell + ivec3(1, 1, 0)));
  cell.z += 1;
  vec4 high = vec4(latticeValue(cell), latticeValue(cell + ivec3(1, 0, 0)), latticeValue(cell + ivec3(0, 1, 0)),
                   latticeValue(cell + ivec3(1, 1, 0)));
  vec4 plane = mix(low, high, f.z);
  vec2 line = mix(plane.xz, plane.yw, f.x);
  return mix(line.x, line.y, f.y);
}

// How much of a wave of `wavelength` a pixel of `footprint` can show: none below two pixels.
float visiblePart(float wavelength, float footprint) { return smoothstep(2.0, 4.0, wavelength / footprint); }

// Octaves of noise around 0, each half as strong and twice as fine; those finer than the pixel fade out.
float turbulence(vec3 p, float footprint) {
  float sum = 0.0, strength = 0.5, wavelength = 1.0;
  for (int octave = 0; octave < 5; ++octave) {
    float part = visiblePart(wavelength, footprint);
    if (part <= 0.0) break;
    sum += strength * part * (2.0 * valueNoise(p / wavelength + float(17 * octave)) - 1.0);
    strength *= 0.5;
    wavelength *= 0.5;
  }
  return sum;
}
