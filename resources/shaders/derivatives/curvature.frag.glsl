// Principal curvatures and the first principal direction from gradient and Hessian, by the shape operator in a basis
// of the tangent plane, Hadwiger et al. 2005 eq. (3) and (4); the direction is derived anew, since eq. (5) is no
// eigenvector in general.
//
// With outward normal n = outward * g / |g| (outward = -1 where inside is above) the surface bends away from n where
// kappa > 0: A = outward * P^T H P / |g| in the basis (u, v). The confidence is 0 where the gradient drowns in noise,
// at umbilics and flats, which have no directions (volume/field/curvature.h has its formula and the same arithmetic), and at
// the border of the volume.
#ifdef SCALED
uniform sampler2D uSurface;
uniform vec3 uScale;  // standard deviation of the Gaussian along each axis, voxels
uniform ivec3 uDims;
#endif
uniform sampler2D uGradient, uHessianDiagonal, uHessianMixed;
uniform int uHessianRow;       // where the first row of the Hessians lies in the picture
uniform float uOutward;
uniform float uGradientNoise;  // standard deviation of a gradient component, data units per mm
uniform float uFlat;           // curvature below which a surface counts as flat, 1/mm
uniform float uHessianNoise;   // standard deviation of a normal second derivative, data units per mm^2
layout(location = 0) out vec4 oKappa;      // kappa1 >= kappa2 (1/mm), confidence, its part from the gradient alone
layout(location = 1) out vec4 oDirection;  // of kappa1: unit, world; w: standard deviation of a curvature over uFlat
#ifdef FLOWLINE
layout(location = 2) out float oFlowline;  // curvature of the gradient's flowline, 1/mm
#endif

#ifdef SCALED
// Samples go on beyond the border by point reflection, which leaves more noise there: of the smoothing across a border at
// distance d the border's own sample takes the part 2 Phi(-d / s), against a variance of 1 / (2 sqrt(pi) s) within.
// Phi by the logistic function.
float noiseAtBorder(ivec2 pixel) {
  vec3 voxel = texelFetch(uSurface, pixel, 0).xyz, scale = max(uScale, vec3(0.2821));  // at least a sample's own variance
  vec3 distance_ = max(min(voxel, vec3(uDims - 1) - voxel), vec3(0.0)) / scale;
  vec3 part = 2.0 / (1.0 + exp(1.702 * min(distance_, vec3(20.0))));
  vec3 variance = 1.0 + 3.5449 * scale * part * part;
  return sqrt(variance.x * variance.y * variance.z);
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oKappa = oDirection = vec4(0.0);
#ifdef FLOWLINE
  oFlowline = 0.0;
#endif
  vec4 gradient = texelFetch(uGradient, pixel, 0);
  ivec2 inHessians = pixel - ivec2(0, uHessianRow);
  vec4 diagonal = texelFetch(uHessianDiagonal, inHessians, 0);
  float scale = max(max(abs(gradient.x), abs(gradient.y)), abs(gradient.z));
  if (gradient.w == 0.0 || diagonal.w == 0.0 || !(scale > 0.0)) return;
  vec3 g = gradient.xyz / scale;
  float relativeLength = length(g);
  vec3 n = uOutward * g / relativeLength;

  // Duff et al. 2017: a basis without branches or cancellation.
  float s = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z), c = n.x * n.y * a;
  vec3 u = vec3(1.0 + s * n.x * n.x * a, s * c, -s * n.x), v = vec3(c, s + n.y * n.y * a, -n.y);

  vec4 mixed = texelFetch(uHessianMixed, inHessians, 0);
  vec3 d = diagonal.xyz / scale, m = mixed.xyz / scale;
  mat3 hessian = mat3(vec3(d.x, m.x, m.y), vec3(m.x, d.y, m.z), vec3(m.yz, d.z));
  vec3 hu = hessian * u, hv = hessian * v;
  float factor = uOutward / relativeLength;
  float a11 = factor * dot(u, hu), a12 = factor * dot(u, hv), a22 = factor * dot(v, hv);
  float mean = 0.5 * (a11 + a22), half_ = 0.5 * (a11 - a22), radius = length(vec2(half_, a12));
  float kappa1 = mean + radius, kappa2 = mean - radius;

#ifdef FLOWLINE
  vec3 hn = hessian * n;
  oFlowline = min(length(vec2(dot(u, hn), dot(v, hn))) / relativeLength, 1e30);
#endif

  // Eigenvector of the larger eigenvalue: of the two forms the one without cancellation.
  vec2 e = half_ >= 0.0 ? vec2(half_ + radius, a12) : vec2(a12, radius - half_);
  float part = max(abs(e.x), abs(e.y));
  if (part > 0.0 && part < 1e-15) e /= part;  // of a surface that is all but flat: squares would underflow
  float norm = length(e);
  float hessianNoise = uHessianNoise;
#ifdef SCALED
  hessianNoise *= noiseAtBorder(pixel);
#endif
  float curvatureNoise = min(hessianNoise / scale / relativeLength, 1e30);
  oDirection = vec4(norm > 0.0 ? (e.x * u + e.y * v) / norm : u, min(curvatureNoise / uFlat, 60000.0));

  float noisy = uGradientNoise > 0.0 ? smoothstep(3.0, 6.0, scale * relativeLength / uGradientNoise) : 1.0;
  noisy *= mixed.w;  // at the border curvature is that of repeated samples
  float round_ = smoothstep(0.02, 0.1, (kappa1 - kappa2) / (abs(kappa1) + abs(kappa2) + uFlat));
  float clear = curvatureNoise > 0.0 ? smoothstep(2.0, 5.0, (kappa1 - kappa2) / curvatureNoise) : 1.0;
  float sure = curvatureNoise > 0.0 ? smoothstep(3.0, 16.0, max(abs(kappa1), abs(kappa2)) / curvatureNoise) : 1.0;
  bool finite = abs(kappa1) < 1e30 && abs(kappa2) < 1e30;
  oKappa = finite ? vec4(kappa1, kappa2, noisy * round_ * clear * (0.75 + 0.25 * sure), noisy) : vec4(0.0);
}
