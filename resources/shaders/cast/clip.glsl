// The first crossings that cuts leave: those of surfaces that are cut count only where the ray is in the kept region,
// an intersection of half-spaces less some boxes (volume/clip). volume/cast/kept_crossings-inl.h does the same.
//
// CLIP: the number of faces; without it nothing is cut. REMOVED: the number of boxes, where there are any. Needs
// trace.glsl, and with CUBIC trace_cubic.glsl.
#ifdef CLIP
#if CLIP > 0
uniform vec4 uClip[CLIP];  // of each face: kept is where dot(face, (p, 1)) <= 0, voxel coordinates
#endif
uniform int uClipped;  // a bit for each surface that is cut
#ifdef REMOVED
uniform mat3 uRemovedAxes;  // along which boxes lie: world from voxel coordinates
uniform vec3 uRemovedLow[REMOVED], uRemovedHigh[REMOVED];
#endif

const int allSurfaces = (1 << SURFACES) - 1;

// Between which t the ray is in the half-spaces, and in each box: not at all where y <= x.
struct Kept {
  vec2 between;
#ifdef REMOVED
  vec2 gone[REMOVED];
#endif
};

Kept keptOf(vec3 origin, vec3 direction) {
  Kept kept;
  kept.between = vec2(-never, never);
#if CLIP > 0
  for (int i = 0; i < CLIP; ++i) {
    float at = dot(uClip[i].xyz, origin) + uClip[i].w, per = dot(uClip[i].xyz, direction);
    if (per > 0.0) kept.between.y = min(kept.between.y, -at / per);
    else if (per < 0.0) kept.between.x = max(kept.between.x, -at / per);
    else if (at > 0.0) kept.between.y = -never;
  }
#endif
#ifdef REMOVED
  vec3 from = uRemovedAxes * origin, along = uRemovedAxes * direction;
  for (int i = 0; i < REMOVED; ++i) {
    vec2 within = vec2(-never, never);
    for (int axis = 0; axis < 3; ++axis) {
      float at = from[axis], per = along[axis], low = uRemovedLow[i][axis], high = uRemovedHigh[i][axis];
      if (per > 0.0) within = vec2(max(within.x, (low - at) / per), min(within.y, (high - at) / per));
      else if (per < 0.0) within = vec2(max(within.x, (high - at) / per), min(within.y, (low - at) / per));
      else if (at < low || at >= high) within.y = -never;
    }
    kept.gone[i] = within;
  }
#endif
  return kept;
}

bool holds(Kept kept, float t) {
  bool held = t >= kept.between.x && t <= kept.between.y;
#ifdef REMOVED
  for (int i = 0; i < REMOVED; ++i) held = held && !(t >= kept.gone[i].x && t < kept.gone[i].y);
#endif
  return held;
}

// What is left of the first stretch that ends behind t; y < x where there is none.
vec2 stretchBehind(Kept kept, float t) {
  vec2 stretch = vec2(max(t, kept.between.x), kept.between.y);
#ifdef REMOVED
  bool moved = true;
  for (int pass = 0; pass < REMOVED && moved; ++pass) {
    moved = false;
    for (int i = 0; i < REMOVED; ++i)
      if (stretch.x >= kept.gone[i].x && stretch.x < kept.gone[i].y) {
        stretch.x = kept.gone[i].y;
        moved = true;
      }
  }
  for (int i = 0; i < REMOVED; ++i)
    if (kept.gone[i].x > stretch.x && kept.gone[i].x < kept.gone[i].y) stretch.y = min(stretch.y, kept.gone[i].x);
#endif
  return stretch;
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
  Kept kept = keptOf(origin, direction);
  bool alike = uClipped == allSurfaces;
  vec2 stretch = vec2(t, never);
  Crossing crossing = Crossing(false, 0.0, 0, inside);
  const int most = 4096;  // crossings passed over
  for (int i = 0; i < most; ++i) {
    if (alike) {  // the ray begins and ends with each stretch of the region
      stretch = stretchBehind(kept, t);
      carried = carried && stretch.x <= t;
      t = stretch.x;
    }
    float end = min(tEnd, stretch.y);
    if (t > end) break;
    crossing = uncut(origin, direction, t, end, carried, inside);
    if (alike && crossing.found && crossing.t <= stretch.y) break;
    if (!alike && (!crossing.found || !isClipped(crossing.surface) || holds(kept, crossing.t))) break;
    carried = crossing.found && !alike;
    if (carried) inside = crossing.inside & 15;
    t = alike ? end : crossing.t;
    crossing.found = false;
    if (alike && (end >= tEnd || end >= kept.between.y)) break;
  }
  return crossing;
#endif
}
