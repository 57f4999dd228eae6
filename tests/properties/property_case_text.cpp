// The text of cases, and simpler ones.
#include <algorithm>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "tests/properties/property_case.h"

namespace isolux::test {

namespace {

std::string listText(const glm::dvec3& v) {
  return exactText(v.x) + ',' + exactText(v.y) + ',' + exactText(v.z);
}

double numberOf(const std::string& text) {
  std::size_t used = 0;
  const double value = std::stod(text, &used);
  if (used != text.size()) throw std::invalid_argument("no number: \"" + text + '"');
  return value;
}

glm::dvec3 vectorOf(const std::string& text) {
  std::istringstream in(text);
  glm::dvec3 v(0.0);
  std::string part;
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::getline(in, part, ',')) throw std::invalid_argument("no vector: \"" + text + '"');
    v[axis] = numberOf(part);
  }
  return v;
}

// Every member with a text: its key, how it is written and how it is read.
struct Part {
  const char* key;
  std::function<std::string(const PropertyCase&)> write;
  std::function<void(PropertyCase&, const std::string&)> read;
};

template <class T>
Part numberPart(const char* key, T PropertyCase::*member) {
  return {key,
          [member](const PropertyCase& c) {
            if constexpr (std::is_same_v<T, std::uint64_t>) return std::to_string(c.*member);
            return exactText(static_cast<double>(c.*member));
          },
          [member](PropertyCase& c, const std::string& text) {
            if constexpr (std::is_same_v<T, std::uint64_t>)
              c.*member = std::stoull(text);
            else
              c.*member = static_cast<T>(numberOf(text));
          }};
}

Part vectorPart(const char* key, glm::dvec3 PropertyCase::*member) {
  return {key, [member](const PropertyCase& c) { return listText(c.*member); },
          [member](PropertyCase& c, const std::string& text) { c.*member = vectorOf(text); }};
}

void readField(PropertyCase& c, const std::string& text) {
  std::string_view rest = text;
  c.field = parseTerm(rest);
  if (!rest.empty()) throw std::invalid_argument("more than a term: \"" + text + '"');
}

const std::vector<Part>& parts() {
  static const std::vector<Part> all{
      {"field", [](const PropertyCase& c) { return textOf(c.field); }, readField},
      numberPart("offset", &PropertyCase::offset),
      numberPart("scale", &PropertyCase::scale),
      {"dims", [](const PropertyCase& c) { return listText(glm::dvec3(c.dims)); },
       [](PropertyCase& c, const std::string& text) { c.dims = glm::ivec3(vectorOf(text)); }},
      {"type", [](const PropertyCase& c) { return c.type; },
       [](PropertyCase& c, const std::string& text) { c.type = text; }},
      numberPart("slope", &PropertyCase::slope),
      numberPart("intercept", &PropertyCase::intercept),
      vectorPart("spacing", &PropertyCase::spacing),
      numberPart("turn", &PropertyCase::turn),
      numberPart("left", &PropertyCase::leftHanded),
      numberPart("voxel", &PropertyCase::ofVoxel),
      numberPart("iso", &PropertyCase::isovalue),
      vectorPart("eye", &PropertyCase::eye),
      vectorPart("target", &PropertyCase::target),
      vectorPart("up", &PropertyCase::up),
      numberPart("fov", &PropertyCase::fov),
      numberPart("ortho", &PropertyCase::orthographic),
      {"picture", [](const PropertyCase& c) { return listText(glm::dvec3(c.picture, 0)); },
       [](PropertyCase& c, const std::string& text) { c.picture = glm::ivec2(glm::dvec2(vectorOf(text))); }},
      numberPart("seed", &PropertyCase::seed)};
  return all;
}

}  // namespace

std::string textOf(const PropertyCase& made) {
  std::string text;
  for (const Part& part : parts())
    text += (text.empty() ? "" : " ") + std::string(part.key) + '=' + part.write(made);
  return text;
}

PropertyCase parseCase(std::string_view text) {
  PropertyCase made;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const auto part = std::find_if(parts().begin(), parts().end(),
                                   [&](const Part& p) { return word.substr(0, equals) == p.key; });
    if (equals == std::string::npos || part == parts().end())
      throw std::invalid_argument("not of a case: \"" + word + '"');
    part->read(made, word.substr(equals + 1));
  }
  return made;
}

namespace {

// From before the middle of a face.
void lookAlong(int axis, PropertyCase& c) {
  c.eye = c.target = glm::dvec3(0.5);
  c.eye[axis] = -2.0;
  c.up = axis == 2 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
}

bool looksAlongAnAxis(const PropertyCase& c) {
  for (int axis = 0; axis < 3; ++axis) {
    PropertyCase other = c;
    lookAlong(axis, other);
    if (other.eye == c.eye && other.target == c.target && other.up == c.up) return true;
  }
  return false;
}

}  // namespace

std::vector<PropertyCase> simplerCases(const PropertyCase& made) {
  std::vector<PropertyCase> simpler;
  const std::string own = textOf(made);
  const auto add = [&](const auto& change) {
    PropertyCase next = made;
    change(next);
    if (textOf(next) != own) simpler.push_back(std::move(next));
  };
  for (const FieldTerm& term : simplerTerms(made.field)) add([&](PropertyCase& c) { c.field = term; });
  for (int axis = 0; axis < 3; ++axis) {
    add([&](PropertyCase& c) { c.dims[axis] = std::max(2, (c.dims[axis] + 1) / 2); });
    add([&](PropertyCase& c) { c.dims[axis] = std::max(2, c.dims[axis] - 1); });
  }
  for (int axis = 0; axis < 3 && !looksAlongAnAxis(made); ++axis)
    add([&](PropertyCase& c) { lookAlong(axis, c); });
  add([](PropertyCase& c) { c.type = "float32"; });
  add([](PropertyCase& c) { c.slope = 1.0, c.intercept = 0.0; });
  add([](PropertyCase& c) { c.offset = 0.0; });
  add([](PropertyCase& c) { c.scale = 1.0; });
  add([](PropertyCase& c) { c.turn = 0, c.leftHanded = false; });
  add([](PropertyCase& c) { c.spacing = glm::dvec3(1.0); });
  add([](PropertyCase& c) { c.orthographic = true; });
  add([](PropertyCase& c) { c.fov = 40.0; });
  add([](PropertyCase& c) { c.ofVoxel = false, c.isovalue = 0.5; });
  add([](PropertyCase& c) { c.picture = glm::max(c.picture / 2, glm::ivec2(1)); });
  add([](PropertyCase& c) { c.seed = 0; });
  return simpler;
}

}  // namespace isolux::test
