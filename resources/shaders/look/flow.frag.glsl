// Streaks: line integral convolution (Cabral & Leedom 1993) of the surface's noise along the direction field, around 0
// and of unit deviation before it is limited to (-1, 1); 0 where there is no confidence, or where the field is too
// incoherent for a streak.
//
// The kernel is a Hann window times a ripple that moves with uPhase, their eq. (4): streaks seem to flow, and the
// picture after one period is the first again. A direction has no sign; the ripple runs both ways at once, weighted by
// how the direction lies to fixed axes (flow_field.frag.glsl).
uniform sampler2D uField, uNoise;
uniform float uHalfLength;  // rays
uniform float uStep;        // rays
uniform float uPhase;       // radians
uniform float uGrain;       // rays
layout(location = 0) out float oFlow;

const float pi = 3.14159265;

// Along s in [-1, 1]: one and a half ripples under the window.
float kernel(float s, float phase) { return (0.5 + 0.5 * cos(pi * s)) * (0.5 + 0.5 * cos(1.5 * pi * s + phase)); }

struct Sums {
  float value, squares, weight;
  float steady;  // how far the field goes on in one sense and with confidence, in parts of both ways
};

void gather(inout Sums sums, float noise, float s, float forward) {
  float weight = mix(kernel(-s, uPhase), kernel(s, uPhase), forward);
  sums.value += weight * noise;
  sums.squares += weight * weight;
  sums.weight += weight;
}

// One way from the pixel. Stops at edges in depth, at the surface's end, and where directions turn abruptly.
void follow(inout Sums sums, vec4 here, float way, float forward) {
  vec2 at = gl_FragCoord.xy, along = way * here.xy, size = vec2(textureSize(uField, 0));
  int steps = int(uHalfLength / uStep);
  float part = 0.5 / float(steps), steady = 1.0;  // of a way of no steps unused
  for (int i = 1; i <= steps; ++i) {
    at += uStep * along;
    // Where the surface ends, a streak does, which says nothing about the field.
    float rest = part * steady * float(steps - i + 1);
    if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, size))) {
      sums.steady += rest;
      return;
    }
    vec4 next = texelFetch(uField, ivec2(at), 0);
    if (next.z < 0.0 || abs(next.z - here.z) > max(uStep, 1.0) * max(here.w, next.w)) {
      sums.steady += rest;
      return;
    }
    float turn = dot(next.xy, along);
    if (abs(turn) < 0.5) return;
    along = turn > 0.0 ? next.xy : -next.xy;
    here = next;
    vec4 noise = texture(uNoise, at / size);
    // Squares of small turns are lost on a smooth field; on noise they soon add up.
    steady *= turn * turn * turn * turn;
    sums.steady += part * steady * noise.z;
    gather(sums, noise.r, way * float(i) * uStep / uHalfLength, forward);
  }
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oFlow = 0.0;
  vec4 here = texelFetch(uField, pixel, 0);
  vec3 noise = texelFetch(uNoise, pixel, 0).xyz;
  if (here.z < 0.0 || !(noise.z > 0.0) || here.xy == vec2(0.0)) return;
  Sums sums = Sums(0.0, 0.0, 0.0, 0.0);
  gather(sums, noise.x, 0.0, noise.y);
  follow(sums, here, 1.0, noise.y);
  follow(sums, here, -1.0, noise.y);
  // The deviation of such a sum, neighbours within a grain being alike: contrast is the same for long and short
  // streaks.
  float deviation = sqrt(sums.squares * max(1.3 * uGrain / uStep, 1.0));
  float value = sums.value / max(deviation, 1e-6);
  oFlow = noise.z * smoothstep(0.15, 0.5, sums.steady) * value / sqrt(1.0 + 0.6 * value * value);
}
