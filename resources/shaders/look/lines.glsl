// Lines from curvature: ridges and valleys, silhouettes and suggestive contours. Each is a coverage in [0, 1].
// Needs surface.glsl and measures.glsl.
uniform float uRidges;
uniform vec2 uRidgeThresholds;  // of ridges and of valleys, 1/mm
uniform vec3 uRidgeColor, uValleyColor;
uniform float uContours, uSuggestiveContours, uContourWidth;  // strengths; rays
uniform vec3 uContourColor;

// A region of the (kappa1, kappa2) domain, Kindlmann et al. 2003 sec. 4: one curvature strong and the other weak.
float lineOf(float strong, float weak, float threshold) {
  float above = smoothstep(0.75, 1.25, strong / max(threshold, 1e-30));
  return above * smoothstep(0.1, 0.5, (strong - abs(weak)) / max(strong, 1e-30));
}
float ridge(vec4 kappa) { return kappa.w * lineOf(kappa.x, kappa.y, uRidgeThresholds.x); }
float valley(vec4 kappa) { return kappa.w * lineOf(-kappa.y, kappa.x, uRidgeThresholds.y); }

// Curvature of the surface along the view direction projected into its tangent plane, positive where it bends away
// from the viewer: Euler's formula. `toViewer` receives that tangent, unit; 0 where the surface faces the viewer.
float radialCurvature(Point p, ivec2 pixel, out vec3 toViewer) {
  vec2 kappa = texelFetch(uKappa, pixel, 0).xy;
  toViewer = safeNormalize(-p.ray + dot(p.ray, p.normal) * p.normal, vec3(0.0));
  float along = dot(toViewer, texelFetch(uDirection, pixel, 0).xyz);
  return p.side * mix(kappa.y, kappa.x, along * along);
}

// Kindlmann et al. 2003 sec. 5: the surface near its silhouette is a circle of curvature kv, so that n.v = c lies
// (1 - sqrt(1 - c^2)) / kv inside the outline; their n.v <= sqrt(T kv (2 - T kv)) is that distance <= T. On what is
// small or rough the line takes no more than an eighth of the radius: it is not blackened whole.
float silhouette(Point p, ivec2 pixel) {
  vec3 toViewer;
  float kv = radialCurvature(p, pixel, toViewer);
  if (!(kv > 0.0)) return 0.0;  // flat or hollow: no outline
  float c = -dot(p.normal, p.ray), inset = c * c / (1.0 + sqrt(max(1.0 - c * c, 0.0)));
  float width = min(uContourWidth, 0.125 / (kv * p.footprint));
  float line = 1.0 - smoothstep(width - 0.5, width + 0.5, inset / (kv * p.footprint));
  return line * smoothstep(0.2, 0.8, width);  // thinner than a ray: too small to have an outline
}

#ifdef SUGGESTIVE
// The radial curvature under a pixel nearby. False where the surface does not go on there: an edge in depth, the other
// side, another direction. `reach`: rays between the pixels.
bool radialCurvatureAt(ivec2 pixel, Point p, float reach, out float kr) {
  kr = 0.0;
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, textureSize(uSurface, 0)))) return false;
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0) return false;
  Point q = pointAt(pixel, surface);
  if (q.side != p.side || abs(dot(q.position - p.position, p.normal)) > 4.0 * reach * p.footprint) return false;
  vec3 toViewer;
  kr = radialCurvature(q, pixel, toViewer);
  return true;
}

// DeCarlo et al. 2003: where the radial curvature crosses zero and rises toward the viewer, there would be an outline
// from a view nearby. Its distance is |kr| / |gradient of kr on screen|. `scale`: a strong curvature of the surface.
float suggestiveContour(Point p, ivec2 pixel, float scale) {
  vec3 toViewer;
  float kr = radialCurvature(p, pixel, toViewer);
  // A surface seen head on has no direction toward the viewer; near there the zeros mean nothing.
  float fade = smoothstep(0.2, 0.5, sqrt(max(1.0 - pow(dot(p.normal, p.ray), 2.0), 0.0)));
  vec2 toward = vec2(dot(toViewer, uRightWorld), dot(toViewer, uUpWorld));
  if (fade <= 0.0 || !(length(toward) > 1e-3)) return 0.0;
  float left, right, down, up, near, far;
  if (!radialCurvatureAt(pixel - ivec2(1, 0), p, 1.0, left) || !radialCurvatureAt(pixel + ivec2(1, 0), p, 1.0, right) ||
      !radialCurvatureAt(pixel - ivec2(0, 1), p, 1.0, down) || !radialCurvatureAt(pixel + ivec2(0, 1), p, 1.0, up))
    return 0.0;
  float steepness = length(vec2(right - left, up - down)) * 0.5;  // 1/mm per ray
  if (!(steepness > 0.0)) return 0.0;
  float line = 1.0 - smoothstep(0.5 * uContourWidth - 0.5, 0.5 * uContourWidth + 0.5, abs(kr) / steepness);
  if (line <= 0.0) return 0.0;
  // A feature is hollow behind the line and bulges before it, as far off as is seen as one: zeros of noise are not.
  float reach = float(uPictureSize.y) / 90.0;
  ivec2 step_ = ivec2(round(reach * normalize(toward)));
  if (!radialCurvatureAt(pixel + step_, p, reach, near) || !radialCurvatureAt(pixel - step_, p, reach, far)) return 0.0;
  return line * fade * smoothstep(0.04, 0.12, min(near, -far) / scale);
}
#endif
