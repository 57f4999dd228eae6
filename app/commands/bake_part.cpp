#include "app/commands/bake_part.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "base/number_text.h"
#include "scene/settings.h"

namespace isolux::app {

std::optional<gi::LatticePart> partOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto [index, count] = parsePart(text, gi::kMostParts);
  return gi::LatticePart{index, count};
}

std::filesystem::path fileOf(const std::filesystem::path& out, const std::optional<gi::LatticePart>& part) {
  if (!part) return out;
  std::string words = gi::partWords(*part);
  std::replace(words.begin(), words.end(), ' ', '-');
  std::filesystem::path file = out;
  return file.replace_extension(words + ".vti");
}

std::string texelsText(const std::string& size, const scene::Scene& scene) {
  if (scene.gi.extent == scene::GiExtent::full) return "full";
  std::string text;
  if (scene.gi.extent == scene::GiExtent::band) {
    text = "band " + base::shortText(scene.gi.band->x, 17) + " " + base::shortText(scene.gi.band->y, 17);
  } else {
    text = "view " + size + " of";
    for (const glm::dvec3& point : {*scene.camera.eye, *scene.camera.target, *scene.camera.up})
      for (int a = 0; a < 3; ++a) text += " " + base::shortText(point[a], 17);
    text += scene.camera.projection == scene::Projection::orthographic ? " orthographic " : " ";
    text += base::shortText(scene.camera.fov, 17);
  }
  // What lookups read around a surface, and whose surface it is.
  const nlohmann::json settings = scene::toJson(scene);
  text += ", " + settings.at("gi").at("interpolation").dump() + " " + settings.at("hit").at("field").dump();
  text += ", surfaces " + base::shortText(*scene.isosurface.value, 17);
  for (const scene::ExtraIsosurface& extra : scene.extraIsosurfaces)
    if (extra.shown) text += " " + base::shortText(*extra.value, 17);
  return text;
}

}  // namespace isolux::app
