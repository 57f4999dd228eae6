// Defines the Scene: everything that determines an image, as one plain value.
//
// Widgets, --set, sessions, undo and recordings all edit Scenes; no other state changes an image. Each member
// is listed once in scene/settings/settings.cpp with its path, default, range, unit and meaning. JSON, --set,
// undo, hashing and the documentation use that list.
//
// World space is millimetres, DICOM/LPS (+x patient left, +y posterior, +z superior). Colours are linear
// RGB (ITU-R BT.709 primaries) in [0, 1]. An empty optional means "automatic": scene::resolve() in
// scene/rules/automatic.h fills it in from the volume.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/choices.h"

namespace isolux::scene {

// The text of Source::labels that draws isosurfaces of a label map's values as of any volume.
inline constexpr const char* kLabelsAsValues = "values";

struct Source {
  std::string path = "phantom:head";  // file, folder, or "phantom:NAME[:SIZE]"
  std::string raw;        // how to read a raw file: "WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]"
  std::string series;     // DICOM SeriesInstanceUID, empty: the series with most slices
  int component = 0;      // channel of a file with several per voxel; -1: their magnitude
  double timeStep = 0.0;  // of a file with several; a fraction blends a step with the next
  DataKind kind = DataKind::automatic;
  int level = 0;                   // 0: full resolution; n: means of about 2^n voxels along each axis
  bool aroundDamage = false;       // unreadable chunks become missing voxels; else the file is rejected
  int meshVoxels = 128;            // of a mesh's distance field, along its longest axis
  std::string labels;              // of a label map, those whose surface is drawn: "2,4-7"; empty: all but 0
  double smoothing = 1.0;          // of that surface, voxels (volume/labels)
  std::string labelNames;          // file of labels' names; empty: those of the file, or beside it
  Csg csg = Csg::none;             // volume/prepared/csg.h
  std::string csgPath;             // the second volume, as `path`
  std::optional<double> csgValue;  // the second volume's isovalue, its data units
  double csgWeight = 0.5;          // of the second volume; csg blend
  bool operator==(const Source&) const = default;
};

// An isosurface of the volume. All are drawn in exact depth order.
struct Surface {
  std::string id{};    // unique in its list (settings/scene_list.h); never changes
  std::string name{};  // for lists; changes no picture
  bool shown = true;
  std::optional<double> value{};  // data units
  glm::dvec3 albedo{0.70, 0.62, 0.50};
  double specular = 0.0;   // reflectance at normal incidence under global illumination (gi/gloss); 0: matt
  double roughness = 0.3;  // of the gloss: 0 is a mirror
  double opacity = 1.0;
  double facingOpacity = 1.0;  // times opacity where the surface faces the viewer: scene/opacity.h
  bool clipped = true;         // by Clip
  // Uncertainty surfaces: the same surface at its isovalue plus and minus this many standard deviations σ of
  // the noise, transparent; 0: none.
  double ghost = 0.0;
  // Names the labels of a label map that it encloses, as Source::labels does; empty: the first such surface
  // has all that no other names.
  std::string labels{};
  std::optional<double> smoothing{};  // voxels; empty: Source::smoothing
  bool labelColors = true;            // each label has its own colour instead of the albedo
  bool operator==(const Surface&) const = default;
};

// All isosurfaces have these in common.
struct Isosurfaces {
  Suggestion suggestion = Suggestion::object;
  Inside inside = Inside::above;
  AlbedoSource albedoSource = AlbedoSource::color;
  ColorMap albedoMap = ColorMap::viridis;
  std::optional<double> albedoLow, albedoHigh;  // data units: the ends of the map
  int layers = 8;  // crossings composited behind one another where surfaces are transparent
  double ghostOpacity = 0.3;
  bool operator==(const Isosurfaces&) const = default;
};

// The connected components of each isosurface's inside that are shown (volume/pieces). A point in a component
// identifies it, mm.
struct Pieces {
  int keep = 0;                    // the largest; 0: all
  double smallest = 0.0;           // mm^3
  std::vector<glm::dvec3> hidden;  // not shown
  std::vector<glm::dvec3> only;    // if not empty, only these are shown
  // Data units: shows only components with at least half inside the body above this value
  // (volume/pieces/body.h). That half must be at least `depth` deep, as a fraction of the body's greatest
  // depth.
  std::optional<double> within{};
  double depth = 0.0;
  bool operator==(const Pieces&) const = default;
};

// A clip plane: clips the side that its normal points to.
struct ClipPlane {
  glm::dvec3 point{0.0};             // mm
  glm::dvec3 normal{0.0, 0.0, 1.0};  // any length but 0
  bool operator==(const ClipPlane&) const = default;
};

// The clip planes and boxes of isosurfaces: everything beyond a plane, outside the clip box, or inside a
// removed box is clipped (volume/clip).
struct Clip {
  std::vector<ClipPlane> planes;               // at most kClipPlanes
  std::vector<glm::dvec3> box;                 // none, or two opposite corners, mm, before it is turned
  glm::dvec4 boxRotation{1.0, 0.0, 0.0, 0.0};  // quaternion (w, x, y, z) about its centre; any length
  std::vector<glm::dvec3> removed;             // two opposite corners of each box, mm; at most kRemovedBoxes
  ClipCap cap = ClipCap::inside;
  bool operator==(const Clip&) const = default;
};

// Display of voxels in slices and on caps, and the point where the three slices meet.
struct Slice {
  std::optional<double> level, width;  // data units: window level and window width
  ColorMap map = ColorMap::automatic;  // automatic: gray
  Field field = Field::trilinear;
  double slab = 0.0;  // mm, half before and half behind the plane
  SlabMode slabMode = SlabMode::mean;
  Convention convention = Convention::radiological;
  double contourWidth = 1.5;           // pixels; 0: no isocontours
  double noiseBand = 0.0;              // isovalue ± this many standard deviations σ of the noise; 0: none
  std::optional<glm::dvec3> position;  // mm
  bool operator==(const Slice&) const = default;
};

// A measurement by the user; points in world mm, as they were clicked. app/marks has the number of points and
// the results of each kind.
struct Mark {
  MarkKind kind = MarkKind::point;
  std::string name;
  std::vector<glm::dvec3> points;
  glm::dvec3 color{1.0, 0.55, 0.05};
  bool shown = true;
  bool operator==(const Mark&) const = default;
};

struct Hit {
  HitMethod method = HitMethod::exact;
  Field field = Field::trilinear;
  double rate = 2.0;                    // r0, samples per voxel along the ray (method sampled)
  double nearFactor = 8.0;              // n: r1 = n r0 near the isovalue
  std::optional<double> nearThreshold;  // delta, data units: nearer than this counts as near
  int refinements = 4;  // regula falsi steps after a sampled hit, Hadwiger et al. 2005 eq. (1)
  bool operator==(const Hit&) const = default;
};

struct Derivatives {
  Field field = Field::cubic;
  Fetch fetch = Fetch::exact;
  std::optional<double> noise;  // standard deviation of a voxel, data units
  // Scales σ of derivatives, mm: standard deviation of the Gaussian that smooths the samples before; 0: none.
  std::optional<double> scale;        // of second derivatives
  std::optional<double> normalScale;  // of the gradient for shading
  bool operator==(const Derivatives&) const = default;
};

// The object's edge: the maximum of |gradient| along the normal nearest to the isosurface (volume/edge).
struct Edge {
  std::optional<double> search;  // mm, each way
  double contrast = 5.0;         // in σ of the noise of |gradient|; weaker maxima are no edge
  bool operator==(const Edge&) const = default;
};

// A second volume that colours the surface of the first, looked up in world space.
struct ColorVolume {
  std::string volume;  // as Source::path; empty: none
  std::string raw;     // as Source::raw
  int component = 0, timeStep = 0;
  Field field = Field::trilinear;
  ColorMap map = ColorMap::automatic;
  std::optional<double> low, high;  // data units of that volume: the ends of the map
  double below = 0.0;               // mm: the largest value within this distance below the surface
  double strength = 1.0;            // how much of the surface's own colour is covered
  bool fade = false;          // strength rises from 0 at the lower end of the map to its value at the upper
  double isolines = 0.0;      // data units from line to line; 0: none
  double isolineWidth = 1.5;  // pixels
  bool operator==(const ColorVolume&) const = default;
};

// A control point of a one-dimensional transfer function.
struct ColorPoint {
  double position = 0.0;  // 0 .. 1, as a fraction of the range
  glm::dvec3 color{0.5};
  bool operator==(const ColorPoint&) const = default;
};

// A control point of the (kappa1, kappa2) colour map, as fractions of the range: -1 .. 1.
struct CurvaturePoint {
  double kappa1 = 0.0, kappa2 = 0.0;
  glm::dvec3 color{0.5};
  bool operator==(const CurvaturePoint&) const = default;
};

struct Look {
  LookMode mode = LookMode::blinn_phong;
  Shading shading = Shading::lambert;  // under the modes that give a colour, not a shading
  double ambient = 0.12;
  double ambientVariation = 0.8;  // ambient light from above is brighter than from below by this fraction
  double specular = 0.2;
  double shininess = 50.0;
  glm::dvec3 innerTint{1.0};  // factor of the surface's own colour on back faces
  glm::dvec3 toneCool{0.03, 0.08, 0.42};
  glm::dvec3 toneWarm{1.0, 0.66, 0.22};
  SolidTexture texture = SolidTexture::none;
  std::optional<double> textureScale;     // mm
  double shadow = 0.0;                    // of the light; 1 leaves only the ambient light
  double occlusion = 1.0;                 // strength of the ambient occlusion by nearby geometry
  std::optional<double> occlusionRadius;  // mm: radius within which geometry occludes
  double fog = 0.0;
  std::optional<glm::dvec3> fogColor;  // automatic: the background
  ColorMap colormap = ColorMap::automatic;
  std::optional<std::vector<ColorPoint>> colormapPoints;  // the user's transfer function instead of colormap
  std::optional<double> rangeLow, rangeHigh;              // of the colour map, in the unit of what it shows
  // Automatic: scene/curvature_map.h, where hue shows the shape index and chroma the curvedness.
  std::optional<std::vector<CurvaturePoint>> curvaturePoints;
  bool legend = true;  // drawn in the image if colours show numbers
  LegendCorner legendCorner = LegendCorner::automatic;
  double accessibility = 0.0;
  // Factor on the surface's own colour over accessibility: 0 in the deepest hollow, 1 where nothing is
  // hollow.
  std::optional<std::vector<ColorPoint>> accessibilityPoints;
  WorkOverlay overlay = WorkOverlay::none;
  double ridges = 0.0;                   // strength of ridge and valley lines
  std::optional<double> ridgeThreshold;  // 1/mm
  double ridgeWidth = 2.0;               // in ridgeWidthUnit
  LengthUnit ridgeWidthUnit = LengthUnit::pixels;
  std::optional<double> ridgeLength;  // mm; shorter lines are left out
  glm::dvec3 ridgeColor{0.95, 0.93, 0.85};
  glm::dvec3 valleyColor{0.03, 0.02, 0.05};
  std::optional<double> contours;   // strength of the silhouette
  double suggestiveContours = 0.0;  // strength
  double contourWidth = 2.0;        // pixels
  glm::dvec3 contourColor{0.0};
  glm::dvec3 backgroundTop{0.10, 0.12, 0.15};
  glm::dvec3 backgroundBottom{0.02, 0.02, 0.03};
  bool operator==(const Look&) const = default;
};

// Streaks along the principal directions of curvature, over any look.
struct Flow {
  double strength = 0.0;  // look.mode flow draws it at full strength
  FlowDirection direction = FlowDirection::maximum;
  double length = 24.0;  // of a streak, pixels
  double grain = 1.5;    // of the noise, pixels
  bool animate = false;
  double speed = 1.0;  // passes of the pattern per second
  double time = 0.0;   // seconds: current time of the animation
  bool operator==(const Flow&) const = default;
};

// The environment of global illumination: an environment map, a constant or a built-in light;
// scene/rules/environment.h defines the choice and the rotation.
struct Environment {
  std::string file;                             // equirectangular, row 0 is up; empty: none
  std::optional<glm::dvec3> constant;           // radiance of a constant environment, if there is no file
  BuiltInLight builtIn = BuiltInLight::studio;  // if there is neither
  double azimuth = 0.0;                         // degrees about up, counterclockwise from above
  double elevation = 0.0;                       // degrees; raises the light from the front
  // Quaternion (w, x, y, z) from its own frame to the world, before azimuth and elevation; any length.
  glm::dvec4 rotation{1.0, 0.0, 0.0, 0.0};
  double exposure = 0.0;  // stops
  bool moves = false;     // it will be rotated or replaced: the baked light must allow that
  bool visible = false;   // behind the surface, instead of the background
  bool shadows = true;    // the surface occludes it; reflected light is not affected
  bool operator==(const Environment&) const = default;
};

// Lights of looks without global illumination, which uses the environment and the light sources instead.
struct Light {
  LightSetup setup = LightSetup::three_point;  // key: without fill, rim and occlusion
  LightSpace space = LightSpace::camera;
  // Toward the light, in camera axes (right, up, toward the viewer) or world axes; need not have unit length.
  glm::dvec3 direction{-0.6, 0.9, 0.7};
  glm::dvec3 color{1.0};
  double intensity = 1.0;
  double fill = 0.15;      // a light from the other side of the viewer, as a fraction of the key light
  double rim = 0.4;        // two lights from behind, one on each side
  double headlight = 0.0;  // brightness of a light at the eye
  Environment environment;
  bool operator==(const Light&) const = default;
};

// A light source of global illumination, fixed in the world.
struct Lamp {
  std::string id{};    // unique in its list (settings/scene_list.h); never changes
  std::string name{};  // for lists; changes no picture
  bool shown = true;
  LampKind kind = LampKind::point;
  std::optional<glm::dvec3> position{};   // mm; point and sphere
  glm::dvec3 direction{-0.5, -0.7, 0.9};  // toward the lamp, world; directional
  std::optional<double> radius{};         // mm; sphere
  double angle = 0.0;                     // degrees, diameter as seen from the volume; directional
  glm::dvec3 color{1.0};
  double intensity = 1.0;  // E / pi on an unoccluded surface at the volume's centre that faces it
  bool shadows = true;     // the surface occludes it; reflected light is not affected
  bool operator==(const Lamp&) const = default;
};

// Global illumination, Wyman et al. 2006: light baked into a lattice whose texels are each lit on their own
// isosurface.
struct Gi {
  GiMode mode = GiMode::automatic;
  GiExtent extent = GiExtent::view;
  std::optional<glm::dvec2> band;  // isovalues, data units; extent band
  GiTexels texels = GiTexels::automatic;
  int samples = 100;  // paths per texel
  DirectionSequence sequence = DirectionSequence::r2;
  int bounces = 1;
  int rouletteDepth = 3;                   // bounces before paths may end at random
  std::optional<double> environmentShare;  // fraction of light samples drawn from the environment (MIS)
  double latticeScale = 1.0;               // texels per voxel and axis
  GiInterpolation interpolation = GiInterpolation::weighted;
  GiPrecision precision = GiPrecision::r11g11b10;
  int shOrder = 5;
  double shWindow = 0.0;  // 0 none, 1 full: against ringing
  int components = 24;    // of a compressed transfer vector, at most
  int componentBits = 4;  // on average
  bool ground = false;    // a plane under the surface that shows its shadow
  bool operator==(const Gi&) const = default;
};

struct Camera {
  std::optional<glm::dvec3> eye;     // mm
  std::optional<glm::dvec3> target;  // mm
  std::optional<glm::dvec3> up;      // any length, not along the view direction
  Frames frames = Frames::surface;
  double fov = 30.0;  // vertical, degrees; the orthographic height is that of the target's distance
  Projection projection = Projection::perspective;
  bool operator==(const Camera&) const = default;
};

struct Picture {
  int supersampling = 2;                        // rays per pixel and axis of an idle image
  StillField restHits = StillField::automatic;  // of hits at rest, where hit.field is trilinear
  std::optional<double> exposure;               // stops, of images lit by global illumination
  Metering metering = Metering::surface;        // of an automatic exposure: gi/trace/exposure_meter.h
  ToneCurve curve = ToneCurve::automatic;       // from linear radiance to the image
  // Annotations on a finished image (app/overlay_text): orientation labels, a scale bar, the shown isovalues.
  // The legend is look.legend.
  bool letters = false, scaleBar = false, isovalue = false;
  bool caveats = true;       // note what the image omits and what was not measured
  bool transparent = false;  // nothing behind the surface
  double pixelRatio = 1.0;   // pixels of the image per pixel in settings
  bool operator==(const Picture&) const = default;
};

constexpr std::size_t kSurfaces = 64;
constexpr std::size_t kLamps = 3;
constexpr std::size_t kClipPlanes = 6;
constexpr std::size_t kRemovedBoxes = 8;

struct Scene {
  Source source;
  std::vector<Surface> surfaces{{.id = "main"}};  // 1 to kSurfaces; automatic values depend on the first
  Isosurfaces isosurface;
  Pieces pieces;
  Clip clip;
  Slice slice;
  std::vector<Mark> marks;
  Hit hit;
  Derivatives derivatives;
  Edge edge;
  ColorVolume color;
  Look look;
  Flow flow;
  Light light;
  std::vector<Lamp> lamps;  // at most kLamps
  Gi gi;
  Camera camera;
  Picture picture;
  bool operator==(const Scene&) const = default;
};

}  // namespace isolux::scene
