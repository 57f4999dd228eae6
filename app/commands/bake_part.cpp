#include "app/commands/bake_part.h"

#include <algorithm>
#include <charconv>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "scene/settings/settings.h"

namespace isolux::app {

std::optional<gi::LatticePart> partOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  gi::LatticePart part;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, part.index);
  const bool slash = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
  const auto count = slash ? std::from_chars(index.ptr + 1, end, part.count) : index;
  if (!slash || count.ec != std::errc() || count.ptr != end || part.index < 1 || part.index > part.count ||
      part.count > gi::kMostParts)
    throw base::Error(base::ErrorKind::usage, "", "--part",
                      "\"" + text + "\" is not i/n, such as 2/5: part i of n, 1 <= i <= n");
  return part;
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
