#include "scene/settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "scene/error.h"
#include "scene/suggestion.h"

namespace isolux::scene {

namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw Error(ErrorKind::usage, "", path, reason);
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
    case SettingType::vector:
      text = "three numbers, each from " + rangeText(setting);
      break;
    case SettingType::text:
      text = "a text";
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

void assignChecked(const Setting& setting, glm::dvec3& member, const json& value) {
  if (!value.is_array() || value.size() != 3) refuseValue(setting, value);
  glm::dvec3 vector;
  for (int i = 0; i < 3; ++i) vector[i] = checkedNumber(setting, value[static_cast<std::size_t>(i)], value);
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
json jsonOf(const std::string& value) {
  return value;
}
json jsonOf(const glm::dvec3& value) {
  return json::array({value.x, value.y, value.z});
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
struct TypeOf<std::string> {
  static constexpr SettingType type = SettingType::text;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<glm::dvec3> {
  static constexpr SettingType type = SettingType::vector;
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
            "The volume: a file, a DICOM folder, or phantom:NAME[:SIZE]."));
  add(entry(
      "source.raw", ISOLUX_MEMBER(source.raw), noRange, "",
      "How to read a file without a header: \"WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]\"."));
  add(entry("source.series", ISOLUX_MEMBER(source.series), noRange, "",
            "The SeriesInstanceUID to take from a DICOM folder; empty takes the series with most slices."));
  add(entry("source.component", ISOLUX_MEMBER(source.component), {-1, 65535}, "",
            "Which component of a file with several per voxel; -1 is their magnitude."));
  add(entry("source.time_step", ISOLUX_MEMBER(source.timeStep), {0, 1e6}, "",
            "Which time step of a file with several."));

  add(entry("isosurface.value", ISOLUX_MEMBER(isosurface.value), {-1e38, 1e38}, "data units",
            "The isovalue; auto takes the one suggested by the histogram."));
  add(choiceEntry("isosurface.inside", ISOLUX_MEMBER(isosurface.inside), {"above", "below"},
                  "Which side of the isovalue is solid; the normal points away from it."));
  add(entry("isosurface.albedo", ISOLUX_MEMBER(isosurface.albedo), unitRange, "linear RGB",
            "The diffuse reflectance of the surface."));

  add(choiceEntry("hit.method", ISOLUX_MEMBER(hit.method), {"sampled", "exact"},
                  "How rays find the surface: equidistant samples with refinement, or the first root of "
                  "the interpolant in every cell."));
  add(entry("hit.rate", ISOLUX_MEMBER(hit.rate), {0.125, 64}, "samples per voxel",
            "How densely a ray is sampled; method sampled only."));
  add(entry("hit.refinements", ISOLUX_MEMBER(hit.refinements), {0, 32}, "",
            "Regula falsi steps after a sampled hit; method sampled only."));

  add(choiceEntry("derivatives.field", ISOLUX_MEMBER(derivatives.field),
                  {"trilinear", "cubic", "cubic_interpolating"},
                  "The reconstruction that gradients come from: trilinear, the tri-cubic B-spline, or the "
                  "B-spline that passes through the samples."));

  add(choiceEntry("look.mode", ISOLUX_MEMBER(look.mode), {"blinn_phong", "lambert", "normal", "depth"},
                  "How the surface is shaded."));
  add(entry("look.ambient", ISOLUX_MEMBER(look.ambient), unitRange, "",
            "Light from everywhere, as a fraction of the albedo."));
  add(entry("look.specular", ISOLUX_MEMBER(look.specular), {0, 4}, "", "Strength of the highlight."));
  add(entry("look.shininess", ISOLUX_MEMBER(look.shininess), {1, 1000}, "",
            "Exponent of the highlight; larger is smaller and sharper."));
  add(entry("look.background_top", ISOLUX_MEMBER(look.backgroundTop), unitRange, "linear RGB",
            "Background at the top of the picture."));
  add(entry("look.background_bottom", ISOLUX_MEMBER(look.backgroundBottom), unitRange, "linear RGB",
            "Background at the bottom of the picture."));

  add(directionEntry(
      "light.direction", ISOLUX_MEMBER(light.direction), "",
      "Toward the light, in camera axes (right, up, toward the viewer); any length but zero."));
  add(entry("light.intensity", ISOLUX_MEMBER(light.intensity), {0, 1e6}, "", "Brightness of the light."));

  add(entry("camera.eye", ISOLUX_MEMBER(camera.eye), positionRange, "mm",
            "Where the viewer is; auto looks from the front, slightly above, at the whole volume."));
  add(entry("camera.target", ISOLUX_MEMBER(camera.target), positionRange, "mm",
            "The point looked at and turned about; auto is the centre of the volume."));
  add(directionEntry("camera.up", ISOLUX_MEMBER(camera.up), "",
                     "The direction that points up in the picture; auto is superior, or anterior when "
                     "looking along the body axis."));
  add(entry("camera.fov", ISOLUX_MEMBER(camera.fov), {1, 160}, "degrees",
            "Vertical field of view; an orthographic picture is as high as this at the target's distance."));
  add(choiceEntry("camera.projection", ISOLUX_MEMBER(camera.projection), {"perspective", "orthographic"},
                  "Whether distant things look smaller."));

  add(entry("picture.supersampling", ISOLUX_MEMBER(picture.supersampling), {1, 4}, "rays per pixel and axis",
            "Anti-aliasing of a picture at rest."));
  add(entry("memory.gpu_budget_mb", ISOLUX_MEMBER(memory.gpuBudgetMb), {16, 1048576}, "MiB",
            "Graphics memory that may be used."));
  return list;
}

#undef ISOLUX_MEMBER

}  // namespace

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
  std::string suggestion = nearest(path, paths);
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
