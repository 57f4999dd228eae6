#include "render/graph/pass.h"

#include <algorithm>
#include <cassert>
#include <functional>

#include <nlohmann/json.hpp>

#include "scene/rules/needs.h"
#include "scene/rules/relevance.h"
#include "scene/settings/scene_list.h"
#include "scene/shown_surfaces.h"
#include "volume/cast/hit_info.h"

namespace isolux::render {

namespace {

// The settings that a pattern covers, without those of items.
std::vector<const scene::Setting*> settingsOf(std::string_view pattern) {
  std::vector<const scene::Setting*> found;
  for (const scene::Setting& setting : scene::settings())
    if (scene::covers(pattern, setting.path)) found.push_back(&setting);
  return found;
}

// The list is searched once for each path that a pass names.
const std::vector<const scene::Setting*>& known(std::string_view path) {
  thread_local std::unordered_map<std::string, std::vector<const scene::Setting*>> found;
  const auto at = found.find(std::string(path));
  return at != found.end() ? at->second : found.emplace(path, settingsOf(path)).first->second;
}

}  // namespace

Asked::Asked(const scene::Scene& ofScene, const FrameRequest& ofRequest, const VolumeState& ofVolume,
             const BrickState& ofBricks, const LightState& ofLight, const OnProcessor& ofProcessor)
    : scene(ofScene),
      request(ofRequest),
      volume(ofVolume),
      bricks(ofBricks),
      light(ofLight),
      onProcessor(ofProcessor) {
  if (request.aovs.empty()) return;
  ofImages_ = scene;
  ofImages_->look.mode = scene::LookMode::edge_offset;
  ofImages_->look.accessibility = 1.0;  // curvature beside it
  ofImages_->look.shading = scene::Shading::gi;
}

std::size_t Asked::groups() const {
  constexpr std::size_t most = volume::HitInfo::kSurfaces;
  if (volume.labelFields > 0) return volume.labelFields;
  return std::max<std::size_t>(1, (scene::visibleSurfaces(scene).size() + most - 1) / most);
}

bool Asked::acts(std::string_view path) const {
  if (request.color && scene::whyInactive(path, scene).empty()) return true;
  return ofImages_ && scene::whyInactive(path, *ofImages_).empty();
}

std::uint64_t Asked::hashOf(const scene::Setting& setting) const {
  const auto at = hashes_.find(&setting);
  if (at != hashes_.end()) return at->second;
  constexpr std::uint64_t inactive = 0;
  const std::uint64_t hash = acts(setting.path) ? std::hash<nlohmann::json>{}(setting.get(scene)) : inactive;
  return hashes_.emplace(&setting, hash).first->second;
}

std::uint64_t Asked::hashOf(const scene::SceneList& list, std::size_t field) const {
  const auto at = itemHashes_.find(&list.fields[field]);
  if (at != itemHashes_.end()) return at->second;
  const std::string_view name = scene::nameOfField(list, list.fields[field]);
  base::Hasher hash;
  for (const std::string& id : list.ids(scene))
    if (acts(std::string(list.path).append(".").append(id).append(".").append(name)))
      hash.add(std::hash<nlohmann::json>{}(list.get(scene, id, field)));
  return itemHashes_.emplace(&list.fields[field], hash).first->second;
}

Declaring& Declaring::reads(std::string_view image) {
  const auto at = std::find(declared.reads.begin(), declared.reads.end(), image);
  if (at == declared.reads.end()) declared.reads.emplace_back(image);
  return *this;
}

Declaring& Declaring::writes(std::string_view image, int bytesPerRay) {
  declared.writes.emplace_back(image);
  declared.bytes.push_back(bytesPerRay);
  return *this;
}

Declaring& Declaring::settings(std::initializer_list<std::string_view> paths,
                               std::initializer_list<std::string_view> except) {
  for (const std::string_view path : paths)
    for (const scene::Setting* setting : known(path))
      if (std::none_of(except.begin(), except.end(),
                       [&](std::string_view pattern) { return scene::covers(pattern, setting->path); }))
        add({setting->path, asked.hashOf(*setting)});
  for (const std::string_view path : paths) {
    const scene::SceneList* const list = scene::listOfPath(path);
    if (list == nullptr) continue;
    for (std::size_t field = 0; field < list->fields.size(); ++field)
      if (std::string pattern = scene::patternOf(list->fields[field].path); scene::covers(path, pattern))
        add({std::move(pattern), asked.hashOf(*list, field)});
  }
  return *this;
}

Declaring& Declaring::add(const Parameter& parameter) {
  const auto same = [&](const Parameter& other) { return other.name == parameter.name; };
  const auto at = std::find_if(declared.parameters.begin(), declared.parameters.end(), same);
  if (at == declared.parameters.end())
    declared.parameters.push_back(parameter);
  else
    assert(at->hash == parameter.hash && "two inputs of one name");
  return *this;
}

Declaring& Declaring::notNeeded(const char* why) {
  declared.notNeeded = why;
  return *this;
}

Declaring& Declaring::volume() {
  return input("volume", asked.volume.hash);
}

Declaring& Declaring::second() {
  const scene::ColorVolume& color = asked.scene.color;
  if (asked.volume.second == 0) return input("second volume", 0);
  return input("second volume", asked.volume.second, color.field, color.below);
}

Declaring& Declaring::pictureSize() {
  const FrameRequest& request = asked.request;
  const Tile tile = request.tile.value_or(Tile{});
  return input("picture size", request.size.x, request.size.y, request.supersampling, tile.origin.x,
               tile.origin.y, tile.size.x, tile.size.y);
}

Declaring& Declaring::isovalues() {
  const scene::Scene& s = asked.scene;
  base::Hasher ghosts;
  for (const scene::Surface& surface : s.surfaces)
    if (surface.shown) ghosts.add(surface.ghost * s.derivatives.noise.value_or(1.0));
  settings({"surfaces.#.value"});
  input("hidden pieces", asked.volume.hidden);
  input("ghosts", std::uint64_t{ghosts});
  ofSurfaces("which isosurfaces are there",
             [](const scene::Surface& surface) { return surface.opacity > 0.0; });
  return input("crossed", asked.volume.crossed);
}

Declaring& Declaring::cuts() {
  const scene::Scene& s = asked.scene;
  if (!scene::cutsSurfaces(s)) return input("cuts", 0);
  settings({"clip.planes", "clip.box", "clip.box_rotation", "clip.removed"});
  return ofSurfaces("cuts", [](const scene::Surface& surface) { return surface.clipped; });
}

Declaring& Declaring::ofSurfaces(const char* name, bool (*holds)(const scene::Surface&)) {
  base::Hasher hash;
  for (const scene::Surface& surface : scene::shownSurfaces(asked.scene)) hash.add(holds(surface));
  return add({name, hash});
}

}  // namespace isolux::render
