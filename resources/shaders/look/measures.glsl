// Curvature measures and the colours that stand for them.
uniform sampler2D uKappa;          // kappa1 >= kappa2 (1/mm), confidence, its part from the gradient
uniform sampler2D uDirection;      // of kappa1, world; w: standard deviation of a curvature over uFlat
uniform sampler2D uColorMap;       // samples along a row, or kappa1 by kappa2
uniform vec2 uRange;               // of the measure, low and high
uniform float uFlat;               // curvature below which a surface counts as flat, 1/mm

const vec3 unknownColor = vec3(0.30);  // where noise leaves no answer

// In [0, 1] over the range; the middle where the range has no width.
float inRange(float value) {
  float width = uRange.y - uRange.x;
  return width == 0.0 ? 0.5 : clamp((value - uRange.x) / width, 0.0, 1.0);
}

vec3 mapped(float t) { return fromRow(uColorMap, t); }

// Bilinear in floats, between the centres of texels.
vec3 mapped2d(vec2 t) {
  ivec2 size = textureSize(uColorMap, 0);
  vec2 x = clamp(t * vec2(size) - 0.5, vec2(0.0), vec2(size - 1));
  ivec2 i = ivec2(min(floor(x), vec2(size - 2)));
  vec2 f = x - vec2(i);
  vec3 low = mix(texelFetch(uColorMap, i, 0).rgb, texelFetch(uColorMap, i + ivec2(1, 0), 0).rgb, f.x);
  vec3 high = mix(texelFetch(uColorMap, i + ivec2(0, 1), 0).rgb, texelFetch(uColorMap, i + 1, 0).rgb, f.x);
  return mix(low, high, f.y);
}

float curvednessOf(vec2 kappa) { return sqrt(0.5) * length(kappa); }

#ifdef EDGE
uniform sampler2D uEdge;  // offset of the edge, mm; its strength

const float noEdge = 1e30;  // render/gl/constants.h holds the same number

vec3 edgeColor(ivec2 pixel) {
  float offset = texelFetch(uEdge, pixel, 0).r;
  return offset < noEdge ? mapped(inRange(offset)) : unknownColor;
}
#elif defined(MEASURE_SQUARE)
vec3 measureColor(vec4 kappa, float noise, ivec2 pixel) {
  return mix(unknownColor, mapped2d(vec2(inRange(kappa.x), inRange(kappa.y))), kappa.w);
}
#elif defined(MEASURE)
#if LOOK == LOOK_FLOWLINE_CURVATURE
uniform sampler2D uFlowline;  // curvature of the gradient's flowline, 1/mm
#endif

float measureOf(vec2 kappa, ivec2 pixel) {
#if LOOK == LOOK_KAPPA1
  return kappa.x;
#elif LOOK == LOOK_KAPPA2
  return kappa.y;
#elif LOOK == LOOK_MEAN_CURVATURE
  return 0.5 * (kappa.x + kappa.y);
#elif LOOK == LOOK_GAUSSIAN_CURVATURE
  return kappa.x * kappa.y;
#elif LOOK == LOOK_SHAPE_INDEX
  // Koenderink & van Doorn 1992: 2/pi atan((k1 + k2) / (k1 - k2)); +-1 at umbilics. Flat points have none.
  return curvednessOf(kappa) > 0.0 ? atan(kappa.x + kappa.y, kappa.x - kappa.y) / 1.57079633 : 0.0;
#elif LOOK == LOOK_CURVEDNESS
  return curvednessOf(kappa);
#elif LOOK == LOOK_FLOWLINE_CURVATURE
  return texelFetch(uFlowline, pixel, 0).r;
#endif
}

// `noise`: the standard deviation of a curvature, 1/mm.
vec3 measureColor(vec4 kappa, float noise, ivec2 pixel) {
  float known = kappa.w;
#if LOOK == LOOK_SHAPE_INDEX  // what is flat but for noise has no shape
  known *= smoothstep(0.3, 1.0, curvednessOf(kappa.xy) / (uFlat + 3.0 * noise));
#endif
  return mix(unknownColor, mapped(inRange(measureOf(kappa.xy, pixel))), known);
}
#endif
