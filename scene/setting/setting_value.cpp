#include "scene/setting/setting_value.h"

#include <cmath>

#include "base/error.h"

namespace isolux::scene {

using nlohmann::json;

namespace {

constexpr std::size_t kMostPositions = 4096;

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

std::string rangeText(const SettingInfo& setting) {
  return numberText(setting.minimum) + " to " + numberText(setting.maximum);
}

std::string allowedText(const SettingInfo& setting) {
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
    case SettingType::positions:
      text = "a list of at most " + std::to_string(kMostPositions) +
             " points x,y,z; x,y,z, each number from " + rangeText(setting);
      break;
    case SettingType::choice: {
      text = "one of ";
      for (std::size_t i = 0; i < setting.choices.size(); ++i) text += (i ? ", " : "") + setting.choices[i];
      break;
    }
  }
  return setting.mayBeAutomatic ? text + ", or auto" : text;
}

}  // namespace

void refuse(const std::string& path, const std::string& reason) {
  throw base::Error(base::ErrorKind::usage, "", path, reason);
}

void refuseValue(const SettingInfo& setting, const json& value) {
  refuse(setting.path, shown(value) + " is not allowed here; allowed is " + allowedText(setting));
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

nlohmann::json jsonOf(const std::vector<CurvaturePoint>& points) {
  json list = json::array();
  for (const CurvaturePoint& p : points)
    list.push_back({p.kappa1, p.kappa2, p.color.x, p.color.y, p.color.z});
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
