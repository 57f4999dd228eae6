// Draws, of colours that are masked, the pixels of the picture that show something before the background: to count them.
// CUT_FACES: faces that cuts lay open, too.
uniform sampler2D uColor;     // alpha: how much is covered, one texel per ray
uniform ivec2 uColorLow;      // its first ray within what is drawn
uniform int uSupersampling;
#ifdef CUT_FACES
uniform sampler2D uCutFaces;  // t; -1: none
#endif
layout(location = 0) out vec4 oNothing;

void main() {
  oNothing = vec4(0.0);
  ivec2 first = ivec2(gl_FragCoord.xy) * uSupersampling;
  for (int y = 0; y < uSupersampling; ++y)
    for (int x = 0; x < uSupersampling; ++x) {
      ivec2 ray = first + ivec2(x, y);
      ivec2 at = ray - uColorLow;
      bool within = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(uColor, 0)));
      if (within && texelFetch(uColor, at, 0).a > 0.0) return;
#ifdef CUT_FACES
      if (texelFetch(uCutFaces, ray, 0).r >= 0.0) return;
#endif
    }
  discard;
}
