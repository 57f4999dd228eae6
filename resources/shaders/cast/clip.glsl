// The first crossings that cuts leave: those of surfaces that are cut count only where the ray is in the kept region,
// an intersection of half-spaces (volume/clip). volume/cast/kept_crossings-inl.h does the same.
//
// CLIP: the number of faces; without it nothing is cut. Needs trace.glsl, and with CUBIC trace_cubic.glsl.
#ifdef CLIP
uniform vec4 uClip[CLIP];  // of each face: kept is where dot(face, (p, 1)) <= 0, voxel coordinates
uniform int uClipped;      // a bit for each surface that is cut

const int allSurfaces = (1 << SURFACES) - 1;

// Between which t the ray is in the region.
vec2 keptOf(vec3 origin, vec3 direction) {
  vec2 kept = vec2(-never, never);
  for (int i = 0; i < CLIP; ++i) {
    float at = dot(uClip[i].xyz, origin) + uClip[i].w, per = dot(uClip[i].xyz, direction);
    if (per > 0.0) kept.y = min(kept.y, -at / per);
    else if (per < 0.0) kept.x = max(kept.x, -at / per);
    else if (at > 0.0) kept.y = -never;
  }
  return kept;
}

bool isClipped(int surface) { return (uClipped >> surface & 1) != 0; }
#endif

Crossing uncut(vec3 origin, vec3 direction, float t, float tEnd, bool carried, int inside) {
#ifdef CUBIC
  return traceCubic(origin, direction, t, tEnd, carried, inside);
#else
  return trace(origin, direction, t, tEnd, carried, inside);
#endif
}

// As trace().
Crossing traceKept(vec3 origin, vec3 direction, float t, float tEnd, bool carried, int inside) {
#ifndef CLIP
  return uncut(origin, direction, t, tEnd, carried, inside);
#else
  vec2 kept = keptOf(origin, direction);
  bool alike = uClipped == allSurfaces;
  if (alike) {  // the ray begins and ends with the region
    carried = carried && kept.x <= t;
    t = max(t, kept.x);
    tEnd = min(tEnd, kept.y);
  }
  Crossing crossing = Crossing(false, 0.0, 0, inside);
  const int most = 4096;  // crossings passed over
  for (int i = 0; i < most && t <= tEnd; ++i) {
    crossing = uncut(origin, direction, t, tEnd, carried, inside);
    if (!crossing.found || !isClipped(crossing.surface) || (crossing.t >= kept.x && crossing.t <= kept.y)) break;
    crossing.found = false;
    if (alike) break;  // behind the end, in the last cell
    t = crossing.t;
    carried = true;
    inside = crossing.inside & 15;
  }
  return crossing;
#endif
}
