// Defines the enumerations of settings, for code that needs no Scene.
//
// scene/settings/settings.cpp has their names on the command line and in sessions; scene/looks.h those of
// looks.
#pragma once

namespace isolux::scene {

// The kind of data in a volume: volume/statistics/data_kind.h. ct_hu: a CT in Hounsfield units.
enum class DataKind { automatic, ct_hu, ct, mr, microscopy, simulation, distance, labels, other };
enum class Csg { none, unite, intersection, difference, blend };  // with the second volume
enum class Frames { surface, volume };                            // shown whole by an automatic camera
enum class Suggestion { object, contrast };                       // the border at an automatic isovalue
enum class Inside { above, below };                               // inside is f >= isovalue, or f <= isovalue
constexpr Inside otherSide(Inside inside) {
  return inside == Inside::above ? Inside::below : Inside::above;
}
enum class HitMethod { sampled, exact };  // Hadwiger et al. 2005 sec. 3.2, or the first root in every cell
// Trilinear interpolation, the tri-cubic B-spline with the samples as coefficients (smoothing), or the
// interpolating B-spline.
enum class Field { trilinear, cubic, cubic_interpolating };
// The field of trilinear hits in idle images. automatic: the interpolating B-spline where the surface visibly
// differs from it (volume/statistics/spline_residual.h).
enum class StillField { automatic, same, cubic_interpolating };
enum class Fetch { fast, exact };  // the texture unit's linear filter, or single texels weighted in float
enum class LookMode {
  blinn_phong,
  lambert,
  tone,
  kappa1,
  kappa2,
  mean_curvature,
  gaussian_curvature,
  shape_index,
  curvedness,
  flowline_curvature,
  curvature_2d,
  accessibility,
  edge_offset,
  flow,
  gi,
  normal,
  curvature_direction,
  depth
};
enum class Shading { unlit, lambert, blinn_phong, tone, gi };  // gi: baked global illumination
enum class SolidTexture { none, marble, wood, checker };
enum class ColorMap {
  automatic,
  viridis,
  cividis,
  inferno,
  gray,
  coolwarm,
  blue_orange,
  purple_green,
  spectral
};
enum class LengthUnit { pixels, mm };
// The corner of the legend; automatic: the corner of the image that shows least of the surface.
enum class LegendCorner { automatic, lower_right, lower_left, upper_right, upper_left };
enum class FlowDirection { maximum, minimum };  // of the curvature: along kappa1 or kappa2
enum class LightSetup { three_point, key };
enum class LightSpace { camera, world };
enum class AlbedoSource { color, map };  // one colour per isosurface, or a colour map over the isovalue
enum class LampKind { point, directional, sphere };
enum class BuiltInLight { studio, window, overcast, sunset, dark_studio };  // gi/sampling/built_in_light.h
// The baked quantity of light; automatic: the least that the scene needs (scene/rules/gi_choice.h).
enum class GiMode { automatic, off, irradiance, transfer, vicinity, shadow };
enum class GiExtent { full, band, view };  // which texels are lit
// Where texels are lit: each on the isosurface through it, for all isovalues; or on the displayed isosurface.
enum class GiTexels { automatic, own, shown };
enum class DirectionSequence { sobol_owen, r2, random };
// Interpolation of baked light between texels, Wyman et al. 2006 fig. 6. weighted: trilinear weights times
// the agreement of a texel's normal with that of the point. The texels' noise is then filtered along their
// own isosurface.
enum class GiInterpolation { closest_isovalue, nearest, trilinear, tricubic, weighted };
enum class GiPrecision { r11g11b10, half };  // of irradiance on the GPU
// The basis of an automatic exposure: light that reaches the surface; light that leaves it towards the front,
// as before session version 9; or the light sources.
enum class Metering { surface, lights, brightness };
// From linear radiance to the image. automatic: filmic under global illumination, else linear.
enum class ToneCurve { automatic, linear, filmic };
// The renderer's work that is drawn over the surface: blocks of the min-max structure that rays enter,
// resident bricks, lit texels (Hadwiger et al. 2005 fig. 2).
enum class WorkOverlay { none, blocks, bricks, texels };
enum class Projection { perspective, orthographic };
enum class ClipCap { none, inside, whole };  // caps: open, values inside the surface, all values
enum class SlabMode { mean, maximum, minimum };
// The patient's right at the left of the image, or at the right.
enum class Convention { radiological, neurological };
// The kind of a measurement (Mark in scene/scene.h).
enum class MarkKind { point, distance, path, angle, circle, thickness, piece };
enum class MemoryLayout { automatic, whole, bricks };

}  // namespace isolux::scene
