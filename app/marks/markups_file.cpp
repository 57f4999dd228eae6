#include "app/marks/markups_file.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/files/files.h"
#include "app/files/json_text.h"
#include "app/marks/mark_kinds.h"
#include "base/color.h"
#include "base/error.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using scene::Mark;
using scene::MarkKind;

constexpr auto kSchema =
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
    "markups-schema-v1.0.3.json#";
constexpr std::size_t kLongestMarkups = std::size_t{64} << 20;

const char* markupTypeOf(const Mark& mark) {
  const std::size_t count = mark.points.size();
  if (mark.kind == MarkKind::distance && count == 2) return "Line";
  if (mark.kind == MarkKind::distance || mark.kind == MarkKind::path) return "Curve";
  return mark.kind == MarkKind::angle && count == 3 ? "Angle" : "Fiducial";
}

ordered_json markupOf(const Mark& mark) {
  ordered_json points = ordered_json::array();
  for (std::size_t i = 0; i < mark.points.size(); ++i) {
    points.push_back(
        {{"id", std::to_string(i + 1)},
         {"label", mark.points.size() == 1 ? mark.name : mark.name + '-' + std::to_string(i + 1)},
         {"position", mark.points[i]},
         {"selected", true},
         {"visibility", true},
         {"positionStatus", "defined"}});
  }
  const glm::dvec3& c = mark.color;
  const ordered_json color = {base::encodeSrgb(c.x), base::encodeSrgb(c.y), base::encodeSrgb(c.z)};
  return {{"type", markupTypeOf(mark)},
          {"name", mark.name},
          {"coordinateSystem", "LPS"},
          {"coordinateUnits", "mm"},
          {"isolux", {{"kind", markKind(mark.kind).name}}},
          {"controlPoints", points},
          {"display",
           {{"visibility", mark.shown},
            {"color", color},
            {"selectedColor", color},
            {"propertiesLabelVisibility", true}}}};
}

// One markup of the file, and where errors in it are.
struct Markup {
  const json& object;
  const std::string& file;
  std::string place;  // "markups[2]"

  [[noreturn]] void fail(const std::string& part, const std::string& reason) const {
    base::throwInput(file, place + part, reason);
  }
  std::string text(const char* key, const std::string& otherwise) const {
    if (!object.contains(key)) return otherwise;
    if (!object[key].is_string()) fail('.' + std::string(key), "is not a text");
    return object[key].get<std::string>();
  }
};

// Whether x and y are those of LPS, not of RAS.
bool isLps(const Markup& markup) {
  const json system = markup.object.value("coordinateSystem", json("LPS"));
  if (system == "LPS" || system == "1" || system == 1) return true;
  if (system == "RAS" || system == "0" || system == 0) return false;
  markup.fail(".coordinateSystem", "is neither LPS nor RAS");
}

double millimetresOf(const Markup& markup) {
  json unit = markup.object.value("coordinateUnits", json("mm"));
  if (unit.is_array() && !unit.empty()) unit = json(unit.front());
  if (unit == "mm") return 1.0;
  if (unit == "um") return 1e-3;
  markup.fail(".coordinateUnits", "is neither mm nor um");
}

struct MarkupPoint {
  glm::dvec3 world;
  std::string label;
  bool visible;
};

glm::dvec3 positionOf(const Markup& markup, const json& point, const std::string& place) {
  const json& position = point.value("position", json());
  if (!position.is_array() || position.size() != 3) markup.fail(place + ".position", "is not [x, y, z]");
  glm::dvec3 world(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const json& number = position[static_cast<std::size_t>(axis)];
    if (!number.is_number()) markup.fail(place + ".position", "is not [x, y, z]");
    world[axis] = number.get<double>();
  }
  return world;
}

bool flag(const json& object, const char* key) {
  return !object.contains(key) || !object[key].is_boolean() || object[key].get<bool>();
}

std::vector<MarkupPoint> pointsOf(const Markup& markup, std::vector<std::string>& notes) {
  const bool lps = isLps(markup);
  const double scale = millimetresOf(markup);
  const json list = markup.object.value("controlPoints", json::array());
  if (!list.is_array()) markup.fail(".controlPoints", "is not a list");
  std::vector<MarkupPoint> points;
  std::size_t unset = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string place = ".controlPoints[" + std::to_string(i) + ']';
    const json& point = list[i];
    if (!point.is_object()) markup.fail(place, "is not an object");
    if (point.contains("positionStatus") && point["positionStatus"] != "defined") {
      ++unset;
      continue;
    }
    const glm::dvec3 world = positionOf(markup, point, place) * scale;
    const bool named = point.contains("label") && point["label"].is_string();
    points.push_back({lps ? world : glm::dvec3(0.0 - world.x, 0.0 - world.y, world.z),
                      named ? point["label"].get<std::string>() : std::string(), flag(point, "visibility")});
  }
  if (unset > 0) notes.push_back(markup.place + ": " + std::to_string(unset) + " points are not set");
  return points;
}

std::optional<glm::dvec3> colorOf(const json& display) {
  for (const char* key : {"selectedColor", "color"}) {
    if (!display.contains(key) || !display[key].is_array() || display[key].size() != 3) continue;
    glm::dvec3 color(0.0);
    bool numbers = true;
    for (int i = 0; i < 3; ++i) {
      const json& part = display[key][static_cast<std::size_t>(i)];
      numbers = numbers && part.is_number();
      if (numbers) color[i] = std::clamp(base::decodeSrgb(part.get<double>()), 0.0, 1.0);
    }
    if (numbers) return color;
  }
  return std::nullopt;
}

std::optional<MarkKind> statedKind(const Markup& markup) {
  const json own = markup.object.value("isolux", json::object());
  if (!own.is_object() || !own.contains("kind")) return std::nullopt;
  for (const MarkKindInfo& info : markKinds())
    if (own["kind"] == info.name) return info.kind;
  return std::nullopt;
}

// Nothing: a type without a kind of mark.
std::optional<MarkKind> kindOf(const Markup& markup, const std::string& type) {
  if (const auto stated = statedKind(markup)) return stated;
  if (type == "Line") return MarkKind::distance;
  if (type == "Curve" || type == "ClosedCurve") return MarkKind::path;
  if (type == "Angle") return MarkKind::angle;
  return std::nullopt;
}

void addMarkup(const Markup& markup, ReadMarks& result) {
  const std::string type = markup.text("type", "");
  if (type.empty()) markup.fail("", "has no type");
  const bool fiducial = type == "Fiducial";
  const auto kind = kindOf(markup, type);
  if (!fiducial && !kind) {
    result.notes.push_back(markup.place + ": a markup of type " + type + " is not a mark");
    return;
  }
  std::vector<MarkupPoint> points = pointsOf(markup, result.notes);
  if (points.empty()) {
    result.notes.push_back(markup.place + ": has no points");
    return;
  }
  if (type == "ClosedCurve") points.push_back(points.front());
  const json display = markup.object.value("display", json::object());
  Mark mark;
  if (display.is_object()) {
    mark.shown = flag(display, "visibility");
    mark.color = colorOf(display).value_or(mark.color);
  }
  const std::string name = markup.text("name", "");
  const auto add = [&](const std::string& called) {
    mark.name = called;
    result.marks.push_back(mark);
  };
  if (!kind) {  // a list of pins
    const bool listShown = mark.shown;
    for (const MarkupPoint& point : points) {
      mark.points = {point.world};
      mark.shown = listShown && point.visible;
      add(!point.label.empty() ? point.label : points.size() == 1 ? name : std::string());
    }
    return;
  }
  mark.kind = *kind;
  for (const MarkupPoint& point : points) mark.points.push_back(point.world);
  if (const std::string wrong = wrongPoints(mark); !wrong.empty()) markup.fail("", wrong);
  add(name);
}

// As marks.list would refuse them: too many, positions beyond its range.
void checkMarks(const std::vector<Mark>& marks, const std::string& file) {
  scene::Scene scene;
  scene.marks = marks;
  try {
    const scene::Setting setting = scene::setting("marks.list");
    setting.set(scene, setting.get(scene));
  } catch (const base::Error& error) {
    base::throwInput(file, "", error.reason());
  }
}

}  // namespace

std::string markupsText(std::span<const Mark> marks) {
  ordered_json file{{"@schema", kSchema}, {"markups", ordered_json::array()}};
  for (const Mark& mark : marks) file["markups"].push_back(markupOf(mark));
  return jsonText(file);
}

ReadMarks parseMarkups(const std::string& text, const std::string& file) {
  json whole;
  try {
    whole = json::parse(text);
  } catch (const json::parse_error& error) {
    base::throwInput(file, "byte " + std::to_string(error.byte), "is not JSON: not a Markups file");
  } catch (const json::exception&) {  // a number that no double holds
    base::throwInput(file, "", "is not JSON: not a Markups file");
  }
  if (!whole.is_object() || !whole.contains("markups") || !whole["markups"].is_array())
    base::throwInput(file, "", "is not a Markups file: it has no list \"markups\"");
  ReadMarks result;
  const json& list = whole["markups"];
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Markup markup{list[i], file, "markups[" + std::to_string(i) + ']'};
    if (!list[i].is_object()) markup.fail("", "is not an object");
    addMarkup(markup, result);
  }
  checkMarks(result.marks, file);
  for (Mark& mark : result.marks)
    if (mark.name.empty()) mark.name = freshName(mark.kind, result.marks);
  return result;
}

ReadMarks readMarkups(const std::filesystem::path& file) {
  return parseMarkups(readTextFile(file, kLongestMarkups), file.string());
}

}  // namespace isolux::app
