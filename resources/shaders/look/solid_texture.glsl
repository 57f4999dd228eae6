// Solid textures (Perlin 1985, Peachey 1985): carved from space, so they have no seams and follow no parametrisation.
// p and footprint in units of the texture's scale. They return a colour made from the surface's own.
#if TEXTURE == TEXTURE_MARBLE
vec3 textured(vec3 albedo, vec3 p, float footprint) {
  // Veins: level lines of a wave bent by turbulence. Its phase moves up to 4 times as fast as p.
  float phase = dot(p, vec3(0.62, 0.35, 0.70)) * 2.0 + 2.4 * turbulence(p, footprint);
  float vein = 1.0 - abs(sin(3.14159265 * phase));
  float sharp = mix(0.19, pow(vein, 4.0), visiblePart(0.5, footprint));  // 0.19: near its mean
  float cloud = turbulence(0.7 * p + 31.0, footprint);
  vec3 stone = mix(albedo, vec3(1.0), clamp(0.30 + 0.35 * cloud, 0.0, 0.6));
  return mix(stone, albedo * vec3(0.26, 0.27, 0.30), 0.85 * sharp);
}
#elif TEXTURE == TEXTURE_WOOD
vec3 textured(vec3 albedo, vec3 p, float footprint) {
  // Rings around the z axis, beside the volume so that trunk and grain both show; grain drawn out along it.
  vec3 bent = p + 0.16 * vec3(turbulence(0.6 * p, footprint), turbulence(0.6 * p + 47.0, footprint), 0.0);
  float radius = 3.0 * length(bent.xy + vec2(1.3, 0.9));
  float ring = fract(radius);
  float profile = smoothstep(0.0, 0.75, ring) * (1.0 - smoothstep(0.88, 1.0, ring));  // slow to dark, sharp to light
  float grain = turbulence(vec3(9.0, 9.0, 0.8) * p, 9.0 * footprint);
  float dark = mix(0.5, profile, visiblePart(0.33, footprint)) + 0.25 * grain;
  return albedo * mix(vec3(1.12, 1.0, 0.86), vec3(0.50, 0.36, 0.24), clamp(dark, 0.0, 1.0));
}
#elif TEXTURE == TEXTURE_CHECKER
// A square wave between -1 and 1 of period 2, averaged over the footprint: the difference of its integral, a
// triangle wave.
vec3 textured(vec3 albedo, vec3 p, float footprint) {
  float width = max(footprint, 1e-4);
  vec3 high = abs(fract(0.5 * (p + 0.5 * width)) - 0.5), low = abs(fract(0.5 * (p - 0.5 * width)) - 0.5);
  vec3 wave = clamp(2.0 * (high - low) / width, -1.0, 1.0);
  return albedo * mix(0.22, 1.0, 0.5 + 0.5 * wave.x * wave.y * wave.z);
}
#endif
