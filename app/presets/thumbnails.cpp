#include "app/presets/thumbnails.h"

#include "app/ready/ready_fields.h"
#include "scene/looks.h"
#include "scene/rules/automatic.h"

namespace isolux::app {

std::vector<Thumbnail> thumbnailsOf(const scene::Scene& scene, std::span<const Preset> presets,
                                    const volume::PreparedVolume& volume) {
  std::vector<Thumbnail> all;
  for (const Preset& preset : presets) {
    Thumbnail& one = all.emplace_back();
    one = {Thumbnail::Kind::preset, preset.name, preset.title, preset.meaning, whyNot(preset, volume), scene};
    if (one.why.empty()) one.scene = withPreset(scene, preset, volume);
  }
  for (const scene::LookInfo& look : scene::looks()) {
    const std::string name(look.name);
    all.push_back({Thumbnail::Kind::look, name, name, std::string(look.meaning), {}, scene});
    all.back().scene.look.mode = look.mode;
  }
  return all;
}

scene::Scene drawnThumbnail(const Thumbnail& thumbnail, const volume::PreparedVolume& volume) {
  scene::Scene scene = thumbnail.scene;
  scene.marks.clear();
  scene.look.legend = false;
  scene.flow.animate = false;
  scene.color = {};  // read by nobody yet
  for (scene::Surface& surface : scene.surfaces) surface.name.clear();
  scene.picture.restHits = scene::StillField::same;
  scene = scene::resolve(scene, volume.facts);
  return withReadyFields(scene, volume);
}

}  // namespace isolux::app
