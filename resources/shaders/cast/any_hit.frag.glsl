// Draws a fragment for each ray that hit a surface: for a query whether there is any.
uniform sampler2D uSurface;
layout(location = 0) out vec4 oNothing;  // masked

void main() {
  if (texelFetch(uSurface, ivec2(gl_FragCoord.xy), 0).w < 0.0) discard;
  oNothing = vec4(0.0);
}
