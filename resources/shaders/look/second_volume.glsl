// What a second volume lays over the surface's own colour: a colour map of its values, and lines where they are multiples
// of a step. Where it has no value the surface keeps its own colour. Needs surface.glsl, color_row.glsl.
uniform sampler2D uSecond;        // value, world gradient (1/mm)
uniform sampler2D uSecondColors;  // from the low end of the range to the high one
uniform vec2 uSecondRange;
uniform float uSecondStrength;    // how much of the surface's own colour is covered
uniform int uSecondFades;         // 1: the strength rises from 0 at the low end
uniform float uIsolines;          // from line to line; 0: none
uniform float uIsolineWidth;      // rays

const float noValue = 3e38;  // render/gl/constants.h holds the same number

// How much of the ray's footprint lines cover: by the distance to the nearest, over the tangent plane and in rays, so
// that they are equally wide everywhere. Where they would be closer than they are wide, they fade.
float isolines(float value, vec3 gradient, Point p) {
  float facing = max(-dot(p.normal, p.ray), 0.05);
  vec3 right = uRightWorld + p.ray * (dot(p.normal, uRightWorld) / facing);
  vec3 up = uUpWorld + p.ray * (dot(p.normal, uUpWorld) / facing);
  float perRay = max(p.footprint * length(vec2(dot(gradient, right), dot(gradient, up))), 1e-30);
  float steps = value / uIsolines;
  float apart = abs(steps - floor(steps + 0.5)) * uIsolines / perRay;
  float room = uIsolines / perRay / uIsolineWidth;
  return clamp(0.5 * uIsolineWidth + 0.5 - apart, 0.0, 1.0) * smoothstep(1.0, 3.0, room);
}

vec3 withSecond(vec3 base, Point p, ivec2 pixel) {
  vec4 second = texelFetch(uSecond, pixel, 0);
  if (!(second.x < noValue)) return base;
  float width = uSecondRange.y - uSecondRange.x;
  float t = width == 0.0 ? 0.5 : clamp((second.x - uSecondRange.x) / width, 0.0, 1.0);
  base = mix(base, fromRow(uSecondColors, t), uSecondFades != 0 ? uSecondStrength * t : uSecondStrength);
  if (uIsolines > 0.0) base *= 1.0 - 0.85 * isolines(second.x, second.yzw, p);
  return base;
}
