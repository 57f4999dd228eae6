// The legend's pixels, placed with its lower left corner at uCorner.
uniform sampler2D uLegend;  // top row first, premultiplied, encoded
uniform ivec2 uCorner;
layout(location = 0) out vec4 oPicture;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) - uCorner;
  oPicture = texelFetch(uLegend, ivec2(at.x, textureSize(uLegend, 0).y - 1 - at.y), 0);
}
