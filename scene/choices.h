// What settings choose among: enumerations alone, for who needs no Scene.
//
// Names on the command line and in sessions: scene/settings.cpp; of looks: scene/looks.h.
#pragma once

namespace isolux::scene {

// What a volume is: volume/statistics/data_kind.h. ct_hu: a CT in Hounsfield units.
enum class DataKind { automatic, ct_hu, ct, mr, microscopy, simulation, distance, labels, other };
enum class Csg { none, unite, intersection, difference };  // of the volume and a second one
enum class Frames { surface, volume };                     // what an automatic camera shows whole
enum class Suggestion { object, contrast };                // border that an automatic isovalue is at
enum class Inside { above, below };                        // inside is f >= isovalue, or f <= isovalue
constexpr Inside otherSide(Inside inside) {
  return inside == Inside::above ? Inside::below : Inside::above;
}
enum class HitMethod { sampled, exact };  // Hadwiger et al. 2005 sec. 3.2, or every cell's first root
// Trilinear interpolation, the tri-cubic B-spline of the samples (smooth), or the B-spline through the
// samples.
enum class Field { trilinear, cubic, cubic_interpolating };
// Of pictures at rest whose hits are trilinear; automatic: the B-spline through the samples where the surface
// lies visibly beside it (volume/statistics/spline_gap.h).
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
  curvature_2d,
  accessibility,
  edge_offset,
  flow,
  gi,
  normal,
  depth
};
enum class Shading { unlit, lambert, blinn_phong, tone, gi };  // gi: stored global illumination
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
// Where the legend stands; automatic: the corner of the picture that shows least of the surface.
enum class LegendCorner { automatic, lower_right, lower_left, upper_right, upper_left };
enum class FlowDirection { maximum, minimum };  // of the curvature: along kappa1 or kappa2
enum class LightSetup { three_point, key };
enum class LightSpace { camera, world };
enum class AlbedoSource { color, map };  // one colour per isosurface, or a colour map over the isovalue
enum class LampKind { point, directional, sphere };
enum class BuiltInLight { studio, window, overcast, sunset };  // gi/sampling/built_in_light.h
// What is stored of the light; automatic: the least that the scene needs (scene/rules/gi_choice.h).
enum class GiMode { automatic, off, irradiance, transfer, vicinity, shadow };
enum class GiExtent { full, band, view };  // which texels are lit
// Where: each on the isosurface through it, for all isovalues; or where the shown isosurface passes it.
enum class GiTexels { automatic, own, shown };
enum class DirectionSequence { sobol_owen, r2, random };
// How stored light is read between texels, Wyman et al. 2006 fig. 6; weighted: trilinear weights times how
// well a texel's normal fits that of the point, of texels whose noise is filtered along their own isosurface.
enum class GiInterpolation { closest_isovalue, nearest, trilinear, tricubic, weighted };
enum class GiPrecision { r11g11b10, half };  // of irradiance on the GPU
enum class Metering { surface, lights };     // what an automatic exposure looks at
enum class Projection { perspective, orthographic };
enum class ClipCap { none, inside, whole };  // cut faces: open, the values inside the surface, all values
enum class SlabMode { mean, maximum, minimum };
enum class Convention { radiological, neurological };  // patient's right on the left of the picture, or right
// What a mark says of its points: scene/scene.h.
enum class MarkKind { point, distance, path, angle, circle, thickness, piece };
enum class MemoryLayout { automatic, whole, bricks };

}  // namespace isolux::scene
