#include "scene/settings/setting_value.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/words.h"
#include "scene/settings/choice_names.h"

namespace isolux::scene {

using nlohmann::json;

namespace {

constexpr std::size_t kMostPoints = 64;
constexpr std::size_t kMostPositions = 4096;
constexpr std::size_t kMostMarks = 1024;

// Shortest text that reads back as the same number, without a trailing ".0".
std::string numberText(double value) {
  std::string text = json(value).dump();
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

// How a refused value is shown. Structured values are only named: they may be arbitrarily deep.
std::string shown(const json& value) {
  if (value.is_array()) return "(a list of " + std::to_string(value.size()) + ")";
  if (value.is_object()) return "(an object)";
  if (value.is_string()) return '"' + value.get_ref<const std::string&>().substr(0, 80) + '"';
  return value.is_number_float() ? numberText(value.get<double>()) : value.dump();
}

std::string rangeText(const SettingInfo& setting) {
  return numberText(setting.minimum) + " to " + numberText(setting.maximum);
}

// What is allowed; those that are numbers have their range behind it.
std::string allowedText(const SettingInfo& setting) {
  static const std::string names[] = {
      "a number from ",
      "a whole number from ",
      "a text",
      "one of ",
      "two numbers, each from ",
      "three numbers, each from ",
      "four numbers, each from ",
      "true or false",
      "a list of 1 to 64 points [kappa1, kappa2, r, g, b], kappas from -1 to 1, colours from 0 to 1",
      "a list of 2 to 64 points [position, r, g, b] in ascending order, all numbers from 0 to 1",
      "a list of at most " + std::to_string(kMostPositions) + " points x,y,z; x,y,z, each number from ",
      "a list of at most " + std::to_string(kClipPlanes) +
          " planes px,py,pz nx,ny,nz; ..., each number from ",
      "a list of at most " + std::to_string(kMostMarks) +
          " marks {\"kind\": ..., \"name\": ..., \"points\": [[x, y, z], ...]}"};
  static_assert(std::size(names) == static_cast<std::size_t>(SettingType::marks) + 1);
  std::string text = names[static_cast<std::size_t>(setting.type)];
  if (text.ends_with("from ")) text += rangeText(setting);
  if (setting.type == SettingType::planes) text += ", normals not zero";
  text += base::joined(setting.choices);
  return setting.mayBeAutomatic ? text + ", or auto" : text;
}

// Rows of N numbers from 0 to 1, the first `positions` of them from `least`.
template <std::size_t N>
std::vector<std::array<double, N>> pointsOf(const SettingInfo& setting, const json& value, std::size_t fewest,
                                            std::size_t positions, double least) {
  if (!value.is_array() || value.size() < fewest || value.size() > kMostPoints) refuseValue(setting, value);
  std::vector<std::array<double, N>> rows;
  for (const json& entry : value) {
    if (!entry.is_array() || entry.size() != N) refuseValue(setting, value);
    std::array<double, N>& row = rows.emplace_back();
    for (std::size_t i = 0; i < N; ++i) {
      if (!entry[i].is_number()) refuseValue(setting, value);
      row[i] = entry[i].get<double>();
      if (!(row[i] >= (i < positions ? least : 0.0) && row[i] <= 1.0)) refuseValue(setting, value);
    }
  }
  return rows;
}

}  // namespace

void refuse(const std::string& path, const std::string& reason) {
  base::throwUsage("", path, reason);
}

void refuseValue(const SettingInfo& setting, const json& value) {
  const bool choice = setting.type == SettingType::choice;
  refuse(setting.path, (choice ? "unknown value " : "invalid value ") + shown(value) +
                           (choice ? "; choose " : "; must be ") + allowedText(setting));
}

double checkedNumber(const SettingInfo& setting, const json& value, const json& whole) {
  if (!value.is_number()) refuseValue(setting, whole);
  const double number = value.get<double>();
  if (!std::isfinite(number) || number < setting.minimum || number > setting.maximum)
    refuseValue(setting, whole);
  return number;
}

void assignChecked(const SettingInfo& setting, double& member, const json& value) {
  member = checkedNumber(setting, value, value);
}

void assignChecked(const SettingInfo& setting, int& member, const json& value) {
  const double number = checkedNumber(setting, value, value);
  if (number != std::floor(number)) refuseValue(setting, value);
  member = static_cast<int>(number);  // the ranges of integers lie within int
}

void assignChecked(const SettingInfo& setting, std::string& member, const json& value) {
  constexpr std::size_t longestText = 4096;
  if (!value.is_string()) refuseValue(setting, value);
  const auto& text = value.get_ref<const std::string&>();
  if (text.size() > longestText) refuse(setting.path, "the text is longer than 4096 bytes");
  if (text.find('\0') != std::string::npos) refuse(setting.path, "the text contains a zero byte");
  member = text;
}

void assignChecked(const SettingInfo& setting, bool& member, const json& value) {
  if (!value.is_boolean()) refuseValue(setting, value);
  member = value.get<bool>();
}

void assignChecked(const SettingInfo& setting, std::vector<CurvaturePoint>& member, const json& value) {
  std::vector<CurvaturePoint> points;
  for (const auto& row : pointsOf<5>(setting, value, 1, 2, -1.0))
    points.push_back({row[0], row[1], {row[2], row[3], row[4]}});
  member = std::move(points);
}

nlohmann::json jsonOf(const std::vector<CurvaturePoint>& points) {
  json list = json::array();
  for (const CurvaturePoint& p : points)
    list.push_back({p.kappa1, p.kappa2, p.color.x, p.color.y, p.color.z});
  return list;
}

void assignChecked(const SettingInfo& setting, std::vector<ColorPoint>& member, const json& value) {
  std::vector<ColorPoint> points;
  for (const auto& row : pointsOf<4>(setting, value, 2, 1, 0.0)) {
    if (!points.empty() && row[0] < points.back().position) refuseValue(setting, value);
    points.push_back({row[0], {row[1], row[2], row[3]}});
  }
  member = std::move(points);
}

nlohmann::json jsonOf(const std::vector<ColorPoint>& points) {
  json list = json::array();
  for (const ColorPoint& p : points) list.push_back({p.position, p.color.x, p.color.y, p.color.z});
  return list;
}

void assignChecked(const SettingInfo& setting, std::vector<glm::dvec3>& member, const json& value) {
  if (!value.is_array() || value.size() > kMostPositions) refuseValue(setting, value);
  std::vector<glm::dvec3> positions(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_array() || value[i].size() != 3) refuseValue(setting, value);
    assignChecked(setting, positions[i], value[i]);
  }
  member = std::move(positions);
}

json jsonOf(const std::vector<glm::dvec3>& positions) {
  json list = json::array();
  for (const glm::dvec3& position : positions) list.push_back(jsonOf(position));
  return list;
}

void assignChecked(const SettingInfo& setting, std::vector<ClipPlane>& member, const json& value) {
  if (!value.is_array() || value.size() > kClipPlanes) refuseValue(setting, value);
  std::vector<ClipPlane> planes;
  for (const json& entry : value) {
    if (!entry.is_array() || entry.size() != 6) refuseValue(setting, value);
    double numbers[6];
    for (std::size_t i = 0; i < 6; ++i) numbers[i] = checkedNumber(setting, entry[i], value);
    planes.push_back({{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}});
    if (glm::length(planes.back().normal) < 1e-6) refuseValue(setting, value);
  }
  member = std::move(planes);
}

json jsonOf(const std::vector<ClipPlane>& planes) {
  json list = json::array();
  for (const ClipPlane& plane : planes)
    list.push_back(
        {plane.point.x, plane.point.y, plane.point.z, plane.normal.x, plane.normal.y, plane.normal.z});
  return list;
}

void assignChecked(const SettingInfo& setting, std::vector<Mark>& member, const json& value) {
  if (!value.is_array() || value.size() > kMostMarks) refuseValue(setting, value);
  SettingInfo positions = setting, color = setting;
  color.minimum = 0.0, color.maximum = 1.0;
  std::vector<Mark> marks;
  for (const json& entry : value) {
    if (!entry.is_object()) refuseValue(setting, value);
    Mark mark;
    for (const auto& [key, part] : entry.items()) {
      if (key == "kind") {
        const auto kind =
            part.is_string() ? choiceNamed<MarkKind>(part.get_ref<const std::string&>()) : std::nullopt;
        if (!kind)
          refuse(
              setting.path,
              "unknown kind of mark; choose one of point, distance, path, angle, circle, thickness, piece");
        mark.kind = *kind;
      } else if (key == "name") {
        assignChecked(setting, mark.name, part);
      } else if (key == "points") {
        assignChecked(positions, mark.points, part);
      } else if (key == "color") {
        assignChecked(color, mark.color, part);
      } else if (key == "shown") {
        assignChecked(setting, mark.shown, part);
      } else {
        refuse(setting.path, "a mark has kind, name, points, color and shown, but no " + shown(json(key)));
      }
    }
    if (mark.points.empty()) refuse(setting.path, "a mark has no points");
    marks.push_back(std::move(mark));
  }
  member = std::move(marks);
}

json jsonOf(const std::vector<Mark>& marks) {
  json list = json::array();
  for (const Mark& mark : marks)
    list.push_back({{"kind", jsonOf(mark.kind)},
                    {"name", mark.name},
                    {"points", jsonOf(mark.points)},
                    {"color", jsonOf(mark.color)},
                    {"shown", mark.shown}});
  return list;
}

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

}  // namespace isolux::scene
