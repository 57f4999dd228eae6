// The background behind a pixel, linear.
uniform vec3 uBackgroundTop, uBackgroundBottom;
vec3 backgroundAt(float height) { return mix(uBackgroundBottom, uBackgroundTop, height); }  // 0 bottom .. 1 top
