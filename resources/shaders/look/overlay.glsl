// The renderer's work over a shaded colour, look.overlay (Hadwiger et al. 2005 fig. 2): a colour for each block, brick
// or texel that the surface passes through, and lines where it leaves them. Needs surface.glsl and lighting.glsl.
uniform vec3 uCellsPerVoxel;  // blocks, bricks or texels along each axis

// Even hues, each far from those of the neighbours, of a brightness that shading stays readable on.
vec3 cellColor(ivec3 cell) {
  float hue = fract(dot(vec3(cell), vec3(0.381966, 0.618034, 0.236068)));
  return 0.25 + 0.75 * clamp(abs(fract(hue + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
}

// Whether the surface crosses a face of its cell within a ray, or a fiftieth of the cell.
bool isAtEdge(vec3 place, Point p) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(uCellsPerVoxel[axis] > 0.0)) continue;
    float cellMm = length(uWorldFromVoxel[axis]) / uCellsPerVoxel[axis];
    float slope = length(cross(p.normal, uWorldFromVoxel[axis])) / length(uWorldFromVoxel[axis]);
    float offMm = abs(place[axis] - round(place[axis])) * cellMm;
    if (offMm < slope * max(p.footprint, 0.02 * cellMm)) return true;
  }
  return false;
}

vec3 withOverlay(vec3 color, Point p, ivec2 pixel, vec3 voxel) {
  vec3 place = voxel * uCellsPerVoxel;
#if OVERLAY == OVERLAY_TEXELS
  place += 0.5;  // a texel is in the middle of its cell
  float lit = texelFetch(uIrradiance, pixel, 0).w;
  vec3 tint = mix(vec3(0.25, 0.35, 1.0), cellColor(ivec3(floor(place))) * vec3(1.0, 0.85, 0.3), lit);
#else
  vec3 tint = cellColor(ivec3(floor(place)));
#endif
  vec3 tinted = 1.5 * dot(color, vec3(0.2126, 0.7152, 0.0722)) * tint;
  return isAtEdge(place, p) ? 0.2 * tinted : mix(color, tinted, 0.7);
}
