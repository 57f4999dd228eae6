// Converts values to the JSON that commands write. An empty optional and a number that is not finite are
// null, a vector is the list of its components.
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

#include "render/gl/gl_context.h"

template <class T>
struct nlohmann::adl_serializer<std::optional<T>> {
  template <class Json>
  static void to_json(Json& json, const std::optional<T>& value) {
    json = value ? Json(*value) : Json();
  }
};

template <glm::length_t length, class T, glm::qualifier qualifier>
struct nlohmann::adl_serializer<glm::vec<length, T, qualifier>> {
  template <class Json>
  static void to_json(Json& json, const glm::vec<length, T, qualifier>& vector) {
    json = Json::array();
    for (glm::length_t i = 0; i < length; ++i) json.push_back(vector[i]);
  }
};

namespace isolux::app {

std::string jsonText(const nlohmann::ordered_json& json);  // indented, ends in a newline
// The keys "context" and "gl": what drew a picture.
void addContext(nlohmann::ordered_json& json, const render::ContextDescription& context);

}  // namespace isolux::app
