#include "scene/settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/suggestion.h"

namespace isolux::scene {

namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw base::Error(base::ErrorKind::usage, "", path, reason);
}

// Shortest text that reads back as the same number, without a trailing ".0".
std::string numberText(double value) {
  std::string text = json(value).dump();
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

// How a refused value is shown. Structured values are only named: they may be arbitrarily deep.
std::string shown(const json& value) {
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  if (value.is_object()) return "an object";
  if (value.is_string()) return '"' + value.get_ref<const std::string&>().substr(0, 80) + '"';
  return value.is_number_float() ? numberText(value.get<double>()) : value.dump();
}

std::string rangeText(const Setting& setting) {
  return numberText(setting.minimum) + " to " + numberText(setting.maximum);
}

std::string allowedText(const Setting& setting) {
  std::string text;
  switch (setting.type) {
    case SettingType::number:
      text = "a number from " + rangeText(setting);
      break;
    case SettingType::integer:
      text = "a whole number from " + rangeText(setting);
      break;
    case SettingType::pair:
      text = "two numbers, each from " + rangeText(setting);
      break;
    case SettingType::vector:
      text = "three numbers, each from " + rangeText(setting);
      break;
    case SettingType::quaternion:
      text = "four numbers, each from " + rangeText(setting);
      break;
    case SettingType::text:
      text = "a text";
      break;
    case SettingType::toggle:
      text = "true or false";
      break;
    case SettingType::points:
      text = "a list of 1 to 64 points [kappa1, kappa2, r, g, b], kappas from -1 to 1, colours from 0 to 1";
      break;
    case SettingType::choice: {
      text = "one of ";
      for (std::size_t i = 0; i < setting.choices.size(); ++i) text += (i ? ", " : "") + setting.choices[i];
      break;
    }
  }
  return setting.mayBeAutomatic ? text + ", or auto" : text;
}

[[noreturn]] void refuseValue(const Setting& setting, const json& value) {
  refuse(setting.path, shown(value) + " is not allowed here; allowed is " + allowedText(setting));
}

double checkedNumber(const Setting& setting, const json& value, const json& whole) {
  if (!value.is_number()) refuseValue(setting, whole);
  const double number = value.get<double>();
  if (!std::isfinite(number) || number < setting.minimum || number > setting.maximum)
    refuseValue(setting, whole);
  return number;
}

void assignChecked(const Setting& setting, double& member, const json& value) {
  member = checkedNumber(setting, value, value);
}

void assignChecked(const Setting& setting, int& member, const json& value) {
  const double number = checkedNumber(setting, value, value);
  if (number != std::floor(number)) refuseValue(setting, value);
  member = static_cast<int>(number);  // the ranges of integers lie within int
}

template <int N>
void assignChecked(const Setting& setting, glm::vec<N, double>& member, const json& value) {
  if (!value.is_array() || value.size() != N) refuseValue(setting, value);
  glm::vec<N, double> vector;
  for (int i = 0; i < N; ++i) vector[i] = checkedNumber(setting, value[static_cast<std::size_t>(i)], value);
  member = vector;
}

void assignChecked(const Setting& setting, std::string& member, const json& value) {
  constexpr std::size_t longestText = 4096;
  if (!value.is_string()) refuseValue(setting, value);
  const auto& text = value.get_ref<const std::string&>();
  if (text.size() > longestText) refuse(setting.path, "the text is longer than 4096 bytes");
  if (text.find('\0') != std::string::npos) refuse(setting.path, "the text contains a zero byte");
  member = text;
}

void assignChecked(const Setting& setting, bool& member, const json& value) {
  if (!value.is_boolean()) refuseValue(setting, value);
  member = value.get<bool>();
}

void assignChecked(const Setting& setting, std::vector<CurvaturePoint>& member, const json& value) {
  constexpr std::size_t mostPoints = 64;
  if (!value.is_array() || value.empty() || value.size() > mostPoints) refuseValue(setting, value);
  std::vector<CurvaturePoint> points;
  for (const json& entry : value) {
    if (!entry.is_array() || entry.size() != 5) refuseValue(setting, value);
    double numbers[5];
    for (std::size_t i = 0; i < 5; ++i) {
      if (!entry[i].is_number()) refuseValue(setting, value);
      numbers[i] = entry[i].get<double>();
      if (!(numbers[i] >= (i < 2 ? -1.0 : 0.0) && numbers[i] <= 1.0)) refuseValue(setting, value);
    }
    points.push_back({numbers[0], numbers[1], {numbers[2], numbers[3], numbers[4]}});
  }
  member = std::move(points);
}

template <class T>
void assignChecked(const Setting& setting, std::optional<T>& member, const json& value) {
  if (value.is_string() && value.get_ref<const std::string&>() == "auto") {
    member.reset();
    return;
  }
  T plain{};
  assignChecked(setting, plain, value);
  member = plain;
}

json jsonOf(double value) {
  return value;
}
json jsonOf(int value) {
  return value;
}
json jsonOf(bool value) {
  return value;
}
json jsonOf(const std::vector<CurvaturePoint>& points) {
  json list = json::array();
  for (const CurvaturePoint& p : points)
    list.push_back({p.kappa1, p.kappa2, p.color.x, p.color.y, p.color.z});
  return list;
}
json jsonOf(const std::string& value) {
  return value;
}
template <int N>
json jsonOf(const glm::vec<N, double>& value) {
  json list = json::array();
  for (int i = 0; i < N; ++i) list.push_back(value[i]);
  return list;
}
template <class T>
json jsonOf(const std::optional<T>& value) {
  return value ? jsonOf(*value) : json("auto");
}

template <class T>
struct TypeOf;
template <>
struct TypeOf<double> {
  static constexpr SettingType type = SettingType::number;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<int> {
  static constexpr SettingType type = SettingType::integer;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<bool> {
  static constexpr SettingType type = SettingType::toggle;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<std::vector<CurvaturePoint>> {
  static constexpr SettingType type = SettingType::points;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<std::string> {
  static constexpr SettingType type = SettingType::text;
  static constexpr bool automatic = false;
};
template <int N>
struct TypeOf<glm::vec<N, double>> {
  static constexpr SettingType type = N == 2   ? SettingType::pair
                                      : N == 3 ? SettingType::vector
                                               : SettingType::quaternion;
  static constexpr bool automatic = false;
};
template <class T>
struct TypeOf<std::optional<T>> {
  static constexpr SettingType type = TypeOf<T>::type;
  static constexpr bool automatic = true;
};

struct Range {
  double minimum, maximum;
};
constexpr Range noRange{0.0, 0.0};  // texts and choices
constexpr Range positionRange{-1e9, 1e9};
constexpr Range unitRange{0.0, 1.0};

// `member` returns the member of a Scene or const Scene by reference.
template <class Member>
Setting entry(std::string path, Member member, Range range, std::string unit, std::string meaning) {
  using T = std::remove_cvref_t<decltype(member(std::declval<const Scene&>()))>;
  Setting result;
  result.path = std::move(path);
  result.type = TypeOf<T>::type;
  result.unit = std::move(unit);
  result.meaning = std::move(meaning);
  result.minimum = range.minimum;
  result.maximum = range.maximum;
  result.mayBeAutomatic = TypeOf<T>::automatic;
  result.get = [member](const Scene& scene) { return jsonOf(member(scene)); };
  // The copy inside serves the checks; it has no get or set of its own.
  result.set = [member, limits = Setting(result)](Scene& scene, const json& value) {
    assignChecked(limits, member(scene), value);
  };
  return result;
}

// A direction: a vector that must not be (nearly) zero.
template <class Member>
Setting directionEntry(std::string path, Member member, std::string unit, std::string meaning) {
  Setting result = entry(std::move(path), member, Range{-1e6, 1e6}, std::move(unit), std::move(meaning));
  result.set = [checked = result.set, member, name = result.path](Scene& scene, const json& value) {
    Scene trial;
    checked(trial, value);
    const std::optional<glm::dvec3> direction = member(trial);
    if (direction && glm::length(*direction) < 1e-6) refuse(name, "a direction must not be zero");
    member(scene) = member(trial);
  };
  return result;
}

// A rotation: a quaternion that must not be (nearly) zero.
template <class Member>
Setting rotationEntry(std::string path, Member member, std::string meaning) {
  Setting result = entry(std::move(path), member, Range{-1e6, 1e6}, "quaternion w,x,y,z", std::move(meaning));
  result.set = [checked = result.set, member, name = result.path](Scene& scene, const json& value) {
    Scene trial;
    checked(trial, value);
    if (glm::length(member(trial)) < 1e-6) refuse(name, "a rotation must not be zero");
    member(scene) = member(trial);
  };
  return result;
}

// A range: the first number must not be above the second.
template <class Member>
Setting bandEntry(std::string path, Member member, std::string unit, std::string meaning) {
  Setting result = entry(std::move(path), member, Range{-1e38, 1e38}, std::move(unit), std::move(meaning));
  result.set = [checked = result.set, member, name = result.path](Scene& scene, const json& value) {
    Scene trial;
    checked(trial, value);
    const std::optional<glm::dvec2> band = member(trial);
    if (band && band->x > band->y) refuse(name, "the lower end must not be above the upper end");
    member(scene) = member(trial);
  };
  return result;
}

// The names stand in the order of the enum's values.
template <class Member>
Setting choiceEntry(std::string path, Member member, std::vector<std::string> names, std::string meaning) {
  using T = std::remove_cvref_t<decltype(member(std::declval<const Scene&>()))>;
  Setting result;
  result.path = std::move(path);
  result.type = SettingType::choice;
  result.meaning = std::move(meaning);
  result.minimum = noRange.minimum;
  result.maximum = noRange.maximum;
  result.choices = std::move(names);
  result.get = [member, choices = result.choices](const Scene& scene) {
    return json(choices.at(static_cast<std::size_t>(member(scene))));
  };
  result.set = [member, limits = Setting(result)](Scene& scene, const json& value) {
    if (!value.is_string()) refuseValue(limits, value);
    const auto& word = value.get_ref<const std::string&>();
    const auto found = std::find(limits.choices.begin(), limits.choices.end(), word);
    if (found == limits.choices.end()) refuseValue(limits, value);
    member(scene) = static_cast<T>(found - limits.choices.begin());
  };
  return result;
}

// A member's name cannot stand in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define ISOLUX_MEMBER(name)  \
  [](auto& scene) -> auto& { \
    return scene.name;       \
  }
// NOLINTEND(bugprone-macro-parentheses)

std::vector<Setting> makeSettings() {
  std::vector<Setting> list;
  const auto add = [&list](Setting setting) { list.push_back(std::move(setting)); };

  add(entry("source.path", ISOLUX_MEMBER(source.path), noRange, "",
            "The volume: a file, a DICOM folder, a triangle mesh, or phantom:NAME[:SIZE]."));
  add(entry(
      "source.raw", ISOLUX_MEMBER(source.raw), noRange, "",
      "How to read a file without a header: \"WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]\"."));
  add(entry("source.series", ISOLUX_MEMBER(source.series), noRange, "",
            "The SeriesInstanceUID to take from a DICOM folder; empty takes the series with most slices."));
  add(entry("source.component", ISOLUX_MEMBER(source.component), {-1, 65535}, "",
            "Which component of a file with several per voxel; -1 is their magnitude."));
  add(entry("source.time_step", ISOLUX_MEMBER(source.timeStep), {0, 1e6}, "",
            "Which time step of a file with several."));
  add(entry("source.mesh_voxels", ISOLUX_MEMBER(source.meshVoxels), {16, 1024}, "voxels",
            "How finely a triangle mesh becomes a distance field: voxels along its longest axis."));
  add(choiceEntry("source.csg", ISOLUX_MEMBER(source.csg), {"none", "union", "intersection", "difference"},
                  "How a second volume is combined with the first, as solids on one grid."));
  add(entry("source.csg_path", ISOLUX_MEMBER(source.csgPath), noRange, "",
            "The second volume, as source.path. A phantom without SIZE is made on the first volume's grid."));
  add(entry("source.csg_value", ISOLUX_MEMBER(source.csgValue), {-1e38, 1e38}, "data units",
            "The isovalue of the second volume's surface, in its own units; auto takes the suggested one."));

  const std::vector<std::string> colorMaps = {"auto",     "viridis",     "cividis",      "inferno", "gray",
                                              "coolwarm", "blue_orange", "purple_green", "spectral"};
  add(entry("isosurface.value", ISOLUX_MEMBER(isosurface.value), {-1e38, 1e38}, "data units",
            "The isovalue; auto takes the one suggested by the histogram."));
  add(choiceEntry("isosurface.inside", ISOLUX_MEMBER(isosurface.inside), {"above", "below"},
                  "Which side of the isovalue is solid; the normal points away from it."));
  add(entry("isosurface.albedo", ISOLUX_MEMBER(isosurface.albedo), unitRange, "linear RGB",
            "The diffuse reflectance of the surface."));
  add(choiceEntry("isosurface.albedo_source", ISOLUX_MEMBER(isosurface.albedoSource), {"color", "map"},
                  "Whether isosurfaces have the reflectances given, or those of a colour map over the "
                  "isovalue."));
  add(choiceEntry("isosurface.albedo_map", ISOLUX_MEMBER(isosurface.albedoMap), colorMaps,
                  "The colour map over the isovalue; auto is viridis."));
  add(entry("isosurface.albedo_low", ISOLUX_MEMBER(isosurface.albedoLow), {-1e38, 1e38}, "data units",
            "The isovalue at the lower end of that map; auto is the volume's minimum."));
  add(entry("isosurface.albedo_high", ISOLUX_MEMBER(isosurface.albedoHigh), {-1e38, 1e38}, "data units",
            "The isovalue at the upper end of that map; auto is the volume's maximum."));
  add(entry("isosurface.opacity", ISOLUX_MEMBER(isosurface.opacity), unitRange, "",
            "How much of what lies behind the surface it hides; 1 hides all."));
  add(entry("isosurface.layers", ISOLUX_MEMBER(isosurface.layers), {1, 64}, "",
            "How many crossings along a ray are composited at most, where surfaces are transparent."));
#define ISOLUX_EXTRA_ISOSURFACE(n)                                                                     \
  add(entry("isosurface" #n ".shown", ISOLUX_MEMBER(isosurface##n.shown), noRange, "",                 \
            "Draws one more isosurface of the same volume."));                                         \
  add(entry("isosurface" #n ".value", ISOLUX_MEMBER(isosurface##n.value), {-1e38, 1e38}, "data units", \
            "Its isovalue; auto spreads the further isovalues from the first toward the maximum."));   \
  add(entry("isosurface" #n ".albedo", ISOLUX_MEMBER(isosurface##n.albedo), unitRange, "linear RGB",   \
            "The diffuse reflectance of that surface."));                                              \
  add(entry("isosurface" #n ".opacity", ISOLUX_MEMBER(isosurface##n.opacity), unitRange, "",           \
            "How much of what lies behind that surface it hides; 1 hides all."))
  ISOLUX_EXTRA_ISOSURFACE(2);
  ISOLUX_EXTRA_ISOSURFACE(3);
  ISOLUX_EXTRA_ISOSURFACE(4);
#undef ISOLUX_EXTRA_ISOSURFACE

  const std::vector<std::string> fields = {"trilinear", "cubic", "cubic_interpolating"};
  add(choiceEntry("hit.method", ISOLUX_MEMBER(hit.method), {"sampled", "exact"},
                  "How rays find the surface: equidistant samples with refinement, or the first root of "
                  "the interpolant in every cell."));
  add(choiceEntry(
      "hit.field", ISOLUX_MEMBER(hit.field), fields,
      "The reconstruction whose surface is hit: trilinear, the tri-cubic B-spline, or the B-spline "
      "that passes through the samples."));
  add(entry("hit.rate", ISOLUX_MEMBER(hit.rate), {0.125, 64}, "samples per voxel",
            "How densely a ray is sampled; method sampled only."));
  add(entry("hit.near_factor", ISOLUX_MEMBER(hit.nearFactor), {1, 64}, "",
            "How many times denser the samples are near the isovalue; method sampled only."));
  add(entry("hit.near_threshold", ISOLUX_MEMBER(hit.nearThreshold), {0, 1e38}, "data units",
            "Samples closer to the isovalue than this are near; auto is what the volume's values change by "
            "from one sample to the next; method sampled only."));
  add(entry("hit.refinements", ISOLUX_MEMBER(hit.refinements), {0, 32}, "",
            "Regula falsi steps after a sampled hit; method sampled only."));

  add(choiceEntry("derivatives.field", ISOLUX_MEMBER(derivatives.field), fields,
                  "The reconstruction that gradients and curvature come from: trilinear, the tri-cubic "
                  "B-spline, or the B-spline that passes through the samples."));
  add(choiceEntry(
      "derivatives.fetch", ISOLUX_MEMBER(derivatives.fetch), {"fast", "exact"},
      "How cubic derivatives read the volume: by the texture unit's linear filter, whose weights many "
      "GPUs round to 8 bits, or by single voxels weighted in float."));
  add(entry(
      "derivatives.noise", ISOLUX_MEMBER(derivatives.noise), {0, 1e38}, "data units",
      "Standard deviation of the noise of a voxel, which the confidence in curvature is measured against; "
      "auto estimates it from the volume."));

  add(choiceEntry(
      "look.mode", ISOLUX_MEMBER(look.mode),
      {"blinn_phong", "lambert", "tone", "kappa1", "kappa2", "mean_curvature", "gaussian_curvature",
       "shape_index", "curvedness", "curvature_2d", "accessibility", "flow", "gi", "normal", "depth"},
      "What the picture shows: the surface under a shading, or a measure of it in colour."));
  add(choiceEntry("look.shading", ISOLUX_MEMBER(look.shading),
                  {"unlit", "lambert", "blinn_phong", "tone", "gi"},
                  "The shading under the modes that give a colour: the curvature maps, accessibility and "
                  "flow; gi is stored "
                  "global illumination."));
  add(entry("look.ambient", ISOLUX_MEMBER(look.ambient), unitRange, "",
            "Light from everywhere, as a fraction of the albedo."));
  add(entry("look.ambient_variation", ISOLUX_MEMBER(look.ambientVariation), unitRange, "",
            "How much brighter the ambient light is from above the picture than from below."));
  add(entry("look.specular", ISOLUX_MEMBER(look.specular), {0, 4}, "", "Strength of the highlight."));
  add(entry("look.shininess", ISOLUX_MEMBER(look.shininess), {1, 1000}, "",
            "Exponent of the highlight; larger is smaller and sharper."));
  add(entry("look.tone_cool", ISOLUX_MEMBER(look.toneCool), unitRange, "linear RGB",
            "Tone shading: the colour of what faces away from the light."));
  add(entry("look.tone_warm", ISOLUX_MEMBER(look.toneWarm), unitRange, "linear RGB",
            "Tone shading: the colour of what faces the light."));
  add(choiceEntry("look.texture", ISOLUX_MEMBER(look.texture), {"none", "marble", "wood", "checker"},
                  "A solid texture, carved from rather than wrapped around the surface; varies the albedo."));
  add(entry("look.texture_scale", ISOLUX_MEMBER(look.textureScale), {1e-9, 1e9}, "mm",
            "Size of the solid texture's features; auto is a tenth of the volume."));
  add(entry("look.shadow", ISOLUX_MEMBER(look.shadow), unitRange, "",
            "Strength of the light's hard shadow, found by a second exact ray from each point."));
  add(entry("look.fog", ISOLUX_MEMBER(look.fog), unitRange, "", "How much the far end of the volume fades."));
  add(entry("look.fog_color", ISOLUX_MEMBER(look.fogColor), unitRange, "linear RGB",
            "What distant things fade to; auto is the background."));
  add(choiceEntry("look.colormap", ISOLUX_MEMBER(look.colormap), colorMaps,
                  "Colours of a measure; auto takes a diverging map for what has a sign, else viridis."));
  add(entry("look.range_low", ISOLUX_MEMBER(look.rangeLow), {-1e38, 1e38}, "1/mm, 1/mm² or 1",
            "The measure at the lower end of the colour map; auto from the surface's own values."));
  add(entry("look.range_high", ISOLUX_MEMBER(look.rangeHigh), {-1e38, 1e38}, "1/mm, 1/mm² or 1",
            "The measure at the upper end of the colour map; auto from the surface's own values."));
  add(entry(
      "look.curvature_points", ISOLUX_MEMBER(look.curvaturePoints), {-1, 1}, "",
      "Mode curvature_2d: control points [kappa1, kappa2, r, g, b] of the colour map, kappas in parts of the "
      "range."));
  add(entry("look.legend", ISOLUX_MEMBER(look.legend), noRange, "",
            "Draws a legend with units where colours stand for numbers."));
  add(entry("look.accessibility", ISOLUX_MEMBER(look.accessibility), unitRange, "",
            "Darkens what is hollow, by curvature, as if dirt had gathered there."));
  add(entry("look.ridges", ISOLUX_MEMBER(look.ridges), unitRange, "", "Strength of ridge and valley lines."));
  add(entry("look.ridge_threshold", ISOLUX_MEMBER(look.ridgeThreshold), {0, 1e38}, "1/mm",
            "Curvature from which on a ridge or valley is drawn; auto from the surface's own values."));
  add(entry("look.ridge_color", ISOLUX_MEMBER(look.ridgeColor), unitRange, "linear RGB",
            "Colour of ridges."));
  add(entry("look.valley_color", ISOLUX_MEMBER(look.valleyColor), unitRange, "linear RGB",
            "Colour of valleys."));
  add(entry("look.contours", ISOLUX_MEMBER(look.contours), unitRange, "",
            "Strength of the silhouette lines."));
  add(entry("look.suggestive_contours", ISOLUX_MEMBER(look.suggestiveContours), unitRange, "",
            "Strength of suggestive contours: where a silhouette would appear from nearby."));
  add(entry("look.contour_width", ISOLUX_MEMBER(look.contourWidth), {0.5, 20}, "pixels",
            "Width of contour lines, the same all over the picture."));
  add(entry("look.contour_color", ISOLUX_MEMBER(look.contourColor), unitRange, "linear RGB",
            "Colour of contour lines."));
  add(entry("look.background_top", ISOLUX_MEMBER(look.backgroundTop), unitRange, "linear RGB",
            "Background at the top of the picture."));
  add(entry("look.background_bottom", ISOLUX_MEMBER(look.backgroundBottom), unitRange, "linear RGB",
            "Background at the bottom of the picture."));

  add(entry("flow.strength", ISOLUX_MEMBER(flow.strength), unitRange, "",
            "Streaks along the directions of curvature, over any look."));
  add(choiceEntry("flow.direction", ISOLUX_MEMBER(flow.direction), {"maximum", "minimum"},
                  "Along the direction of the larger or of the smaller principal curvature."));
  add(entry("flow.length", ISOLUX_MEMBER(flow.length), {2, 200}, "pixels", "Length of a streak."));
  add(entry("flow.grain", ISOLUX_MEMBER(flow.grain), {1, 20}, "pixels", "Size of the noise's grains."));
  add(entry("flow.animate", ISOLUX_MEMBER(flow.animate), noRange, "",
            "Lets the streaks move, in the window."));
  add(entry("flow.speed", ISOLUX_MEMBER(flow.speed), {0.05, 10}, "1/s",
            "How often the pattern passes in a second."));
  add(entry("flow.time", ISOLUX_MEMBER(flow.time), {0, 1e6}, "s", "Where the animation stands."));

  add(choiceEntry("light.space", ISOLUX_MEMBER(light.space), {"camera", "world"},
                  "Whether the light moves with the viewer or stays with the volume."));
  add(directionEntry(
      "light.direction", ISOLUX_MEMBER(light.direction), "",
      "Toward the light, in camera axes (right, up, toward the viewer) or world axes; any length but zero."));
  add(entry("light.color", ISOLUX_MEMBER(light.color), unitRange, "linear RGB", "Colour of the light."));
  add(entry("light.intensity", ISOLUX_MEMBER(light.intensity), {0, 1e6}, "", "Brightness of the light."));
  add(entry("light.headlight", ISOLUX_MEMBER(light.headlight), {0, 1e6}, "",
            "Brightness of a second, white light at the eye."));

  add(entry(
      "light.environment.file", ISOLUX_MEMBER(light.environment.file), noRange, "",
      "The light probe around everything, equirectangular, its first row up: .hdr, .exr, ...; empty is a "
      "sky of one colour."));
  add(entry("light.environment.constant", ISOLUX_MEMBER(light.environment.constant), {0, 1e6},
            "linear RGB radiance", "The radiance of a sky of one colour; without a file only."));
  add(rotationEntry("light.environment.rotation", ISOLUX_MEMBER(light.environment.rotation),
                    "Turns the light probe: from its own axes to the world's."));
  add(entry("light.environment.exposure", ISOLUX_MEMBER(light.environment.exposure), {-40, 40}, "stops",
            "Multiplies the environment's radiance by 2 to this power."));
  add(entry("light.environment.moves", ISOLUX_MEMBER(light.environment.moves), noRange, "",
            "The environment will be turned or exchanged: gi.mode auto then stores light so that this costs "
            "nothing anew."));
  add(entry("light.environment.visible", ISOLUX_MEMBER(light.environment.visible), noRange, "",
            "Shows the environment behind the surface."));
#define ISOLUX_LAMP(n)                                                                                       \
  add(entry("lamp" #n ".shown", ISOLUX_MEMBER(lamp##n.shown), noRange, "",                                   \
            "Switches on a lamp of global illumination."));                                                  \
  add(choiceEntry("lamp" #n ".kind", ISOLUX_MEMBER(lamp##n.kind), {"point", "directional", "sphere"},        \
                  "A point, a distant lamp, or a luminous sphere."));                                        \
  add(entry("lamp" #n ".position", ISOLUX_MEMBER(lamp##n.position), positionRange, "mm",                     \
            "Where a point or sphere is; auto is above the volume, toward the front and the left."));        \
  add(directionEntry("lamp" #n ".direction", ISOLUX_MEMBER(lamp##n.direction), "",                           \
                     "Toward a distant lamp, world axes; any length but zero."));                            \
  add(entry("lamp" #n ".radius", ISOLUX_MEMBER(lamp##n.radius), {1e-9, 1e9}, "mm",                           \
            "Of a luminous sphere; larger gives softer shadows; auto is a tenth of the volume."));           \
  add(entry("lamp" #n ".angle", ISOLUX_MEMBER(lamp##n.angle), {0, 90}, "degrees",                            \
            "Diameter of a distant lamp as seen from the volume; the sun has 0.53, 0 gives hard shadows.")); \
  add(entry("lamp" #n ".color", ISOLUX_MEMBER(lamp##n.color), unitRange, "linear RGB",                       \
            "Colour of the lamp."));                                                                         \
  add(entry("lamp" #n ".intensity", ISOLUX_MEMBER(lamp##n.intensity), {0, 1e6}, "",                          \
            "Brightness of a white surface at the volume's centre that faces the lamp."))
  ISOLUX_LAMP(1);
  ISOLUX_LAMP(2);
  ISOLUX_LAMP(3);
#undef ISOLUX_LAMP

  add(choiceEntry(
      "gi.mode", ISOLUX_MEMBER(gi.mode), {"auto", "off", "irradiance", "transfer", "vicinity", "shadow"},
      "What is stored of the light: irradiance (static light), transfer (spherical harmonics: the "
      "environment may move), vicinity (a sky of one colour, no bounces), shadow (no bounces); auto "
      "takes the least that the scene needs."));
  add(choiceEntry("gi.extent", ISOLUX_MEMBER(gi.extent), {"full", "band", "view"},
                  "Which texels are lit: all, those that isovalues of gi.band can show, or those that are "
                  "seen."));
  add(bandEntry("gi.band", ISOLUX_MEMBER(gi.band), "data units",
                "The isovalues of interest, low and high; auto is a twentieth of the volume's range about "
                "the isovalue."));
  add(entry("gi.samples", ISOLUX_MEMBER(gi.samples), {1, 1000000}, "paths per texel",
            "More have less noise: four times as many halve it."));
  add(choiceEntry(
      "gi.sequence", ISOLUX_MEMBER(gi.sequence), {"sobol_owen", "r2", "random"},
      "The directions of a texel's paths: scrambled Sobol points, Roberts' R2 with a shift for each "
      "texel, or independent random numbers."));
  add(entry("gi.bounces", ISOLUX_MEMBER(gi.bounces), {0, 1000}, "",
            "Diffuse reflections on a light's way to a texel; 0 is direct light only."));
  add(entry("gi.roulette_depth", ISOLUX_MEMBER(gi.rouletteDepth), {0, 1000}, "bounces",
            "From this bounce on paths end at random, with the probability that light is absorbed."));
  add(entry(
      "gi.environment_share", ISOLUX_MEMBER(gi.environmentShare), {0, 0.95}, "",
      "The part of the directions that is drawn from the environment instead of the surface; auto is 0.75 "
      "under a light probe, 0.5 with more than one bounce."));
  add(entry("gi.lattice_scale", ISOLUX_MEMBER(gi.latticeScale), {0.125, 4}, "texels per voxel and axis",
            "How finely light is stored."));
  add(choiceEntry(
      "gi.interpolation", ISOLUX_MEMBER(gi.interpolation),
      {"closest_isovalue", "nearest", "trilinear", "tricubic", "weighted"},
      "How stored light is read between texels; weighted favours texels whose normal fits, and takes the "
      "noise out along their isosurfaces."));
  add(choiceEntry("gi.precision", ISOLUX_MEMBER(gi.precision), {"r11g11b10", "half"},
                  "Numbers in which irradiance is kept on the graphics card: 4 or 8 bytes per texel."));
  add(entry("gi.sh_order", ISOLUX_MEMBER(gi.shOrder), {1, 8}, "",
            "Bands of spherical harmonics of stored transfer; more follow sharper light."));
  add(entry("gi.sh_window", ISOLUX_MEMBER(gi.shWindow), unitRange, "",
            "Damps high bands of the environment against ringing."));
  add(entry("gi.components", ISOLUX_MEMBER(gi.components), {4, 192}, "numbers per texel",
            "Stored transfer is compressed to this many principal components."));
  add(entry("gi.component_bits", ISOLUX_MEMBER(gi.componentBits), {8, 16}, "bits",
            "Of each component: up to 8 are stored in 8 bits, more in 16."));
  add(entry("gi.threads", ISOLUX_MEMBER(gi.threads), {1, 1024}, "",
            "Threads that compute light; auto is one per core."));

  add(entry("camera.eye", ISOLUX_MEMBER(camera.eye), positionRange, "mm",
            "Where the viewer is; auto looks from the front, slightly above, at the whole volume."));
  add(entry("camera.target", ISOLUX_MEMBER(camera.target), positionRange, "mm",
            "The point looked at and turned about; auto is the centre of the volume."));
  add(directionEntry(
      "camera.up", ISOLUX_MEMBER(camera.up), "",
      "The direction that points up in the picture; auto is superior (y for meshes), or anterior "
      "(the front) when looking along it."));
  add(entry("camera.fov", ISOLUX_MEMBER(camera.fov), {1, 160}, "degrees",
            "Vertical field of view; an orthographic picture is as high as this at the target's distance."));
  add(choiceEntry("camera.projection", ISOLUX_MEMBER(camera.projection), {"perspective", "orthographic"},
                  "Whether distant things look smaller."));

  add(entry("picture.supersampling", ISOLUX_MEMBER(picture.supersampling), {1, 4}, "rays per pixel and axis",
            "Anti-aliasing of a picture at rest."));
  add(entry("picture.adaptive", ISOLUX_MEMBER(picture.adaptive), noRange, "",
            "Pictures in motion shrink until they are quick enough; the full picture follows at rest."));
  add(entry("picture.motion_target", ISOLUX_MEMBER(picture.motionTarget), {5, 2000}, "ms",
            "How long a picture in motion may take."));
  add(entry("picture.exposure", ISOLUX_MEMBER(picture.exposure), {-40, 40}, "stops",
            "Brightness of pictures lit by global illumination; auto fits the lights."));
  add(entry("memory.gpu_budget_mb", ISOLUX_MEMBER(memory.gpuBudgetMb), {16, 1048576}, "MiB",
            "Graphics memory that the voxels may use."));
  add(choiceEntry(
      "memory.layout", ISOLUX_MEMBER(memory.layout), {"auto", "whole", "bricks"},
      "The volume as one texture, or as bricks of which only those needed are resident; auto takes one "
      "texture where it fits."));
  return list;
}

#undef ISOLUX_MEMBER

}  // namespace

std::size_t componentsOf(SettingType type) {
  switch (type) {
    case SettingType::pair:
      return 2;
    case SettingType::vector:
      return 3;
    case SettingType::quaternion:
      return 4;
    default:
      return 0;
  }
}

std::span<const Setting> settings() {
  static const std::vector<Setting> list = makeSettings();
  return list;
}

const Setting& setting(std::string_view path) {
  const std::span<const Setting> list = settings();
  const auto found = std::find_if(list.begin(), list.end(), [&](const Setting& s) { return s.path == path; });
  if (found != list.end()) return *found;
  std::vector<std::string> paths;
  for (const Setting& known : list) paths.push_back(known.path);
  std::string suggestion = base::nearest(path, paths);
  if (suggestion.empty()) {  // "fov", "view.fov": the right name in no or the wrong group
    const std::string name = '.' + std::string(path.substr(path.rfind('.') + 1));
    const auto same =
        std::find_if(paths.begin(), paths.end(), [&](const auto& p) { return p.ends_with(name); });
    if (same != paths.end()) suggestion = *same;
  }
  refuse(std::string(path.substr(0, 200)), suggestion.empty()
                                               ? "unknown setting; `isolux settings` lists all"
                                               : "unknown setting, did you mean " + suggestion + "?");
}

}  // namespace isolux::scene
