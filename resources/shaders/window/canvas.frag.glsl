// Shows a picture on the canvas of the window: pixel for pixel where both have one size, else scaled. The
// picture before it fades into it.
uniform sampler2D uPicture;
uniform sampler2D uBefore;
uniform float uOpacityBefore;  // 0: it is not read
uniform ivec2 uSize;           // of the canvas, pixels
uniform int uTopRowFirst;      // of uPicture
layout(location = 0) out vec4 color;

vec3 pixelOf(sampler2D picture, bool topRowFirst) {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (topRowFirst) pixel.y = uSize.y - 1 - pixel.y;
  if (textureSize(picture, 0) == uSize) return texelFetch(picture, pixel, 0).rgb;
  return textureLod(picture, (vec2(pixel) + 0.5) / vec2(uSize), 0.0).rgb;
}

void main() {
  color = vec4(pixelOf(uPicture, uTopRowFirst != 0), 1.0);
  if (uOpacityBefore > 0.0) color.rgb = mix(color.rgb, pixelOf(uBefore, false), uOpacityBefore);
}
