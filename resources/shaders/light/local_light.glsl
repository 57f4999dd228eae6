// Light without anything in its way, for where none is stored. LAMP_COUNT: 0 to 3.
uniform vec3 uLocalSky[9];  // of the irradiance: factors of 1, y, z, x, xy, yz, 3 z^2 - 1, xz, x^2 - y^2 of the normal

// A lamp: E = power * cosine, for a lamp at a place over the square of the distance (mm), at least its own radius.
struct Lamp {
  vec4 place;  // mm from voxel 0, 1; or unit, toward the lamp, 0
  vec4 power;  // rgb; radius, mm; of a distant one the sine of half its angle
};
#if LAMP_COUNT > 0
uniform Lamp uLamps[LAMP_COUNT];
#endif

vec3 localSky(vec3 n) {
  vec3 e = uLocalSky[0] + n.y * uLocalSky[1] + n.z * uLocalSky[2] + n.x * uLocalSky[3];
  e += n.x * n.y * uLocalSky[4] + n.y * n.z * uLocalSky[5] + (3.0 * n.z * n.z - 1.0) * uLocalSky[6];
  e += n.x * n.z * uLocalSky[7] + (n.x * n.x - n.y * n.y) * uLocalSky[8];
  return max(e, vec3(0.0));
}

vec3 localLamps(vec3 position, vec3 n) {
  vec3 e = vec3(0.0);
#if LAMP_COUNT > 0
  for (int i = 0; i < LAMP_COUNT; ++i) {
    vec3 way = uLamps[i].place.xyz - uLamps[i].place.w * position;
    float square = max(dot(way, way), 1e-30);
    float cosine = max(dot(n, way) * inversesqrt(square), 0.0), radius = uLamps[i].power.w;
    e += uLamps[i].power.rgb * cosine / (uLamps[i].place.w > 0.0 ? max(square, radius * radius) : 1.0);
  }
#endif
  return e;
}
