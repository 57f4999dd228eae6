// A colour map's samples along a row: linear between their centres, in floats.
vec3 fromRow(sampler2D row, float t) {
  float x = t * float(textureSize(row, 0).x - 1);
  int i = int(min(floor(x), float(textureSize(row, 0).x - 2)));
  return mix(texelFetch(row, ivec2(i, 0), 0).rgb, texelFetch(row, ivec2(i + 1, 0), 0).rgb, x - float(i));
}
