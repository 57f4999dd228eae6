// How the settings panel is organised: which group a setting stands in, in which order, under which name.
//
// Every setting that a user edits in the panel stands in exactly one group. A setting that is not named here
// appears at the end of the group that takes its prefix, or in a group of its own.
#pragma once

#include <vector>

#include <QString>

#include "scene/settings/scene_list.h"

namespace isolux::ui {

// The title of the group that also shows the light probe (ui/editors/environment_preview.h).
inline constexpr const char* environmentGroup = "Environment";

struct PanelGroup {
  QString title;
  bool open;  // at first
  std::vector<scene::Setting> settings;
  const scene::SceneList* list = nullptr;  // the group shows the items of this list
};

// Without the source, which the volume panel edits.
std::vector<PanelGroup> panelGroups();

// "look.tone_cool" -> "Tone cool"; `indented`: a detail of the row above.
struct RowLabel {
  QString text;
  bool indented;
};
RowLabel labelOf(const scene::SettingInfo& setting);
// Returns the name of an item of a list, or "Light 2".
QString titleOf(const scene::SceneList& list, const scene::Scene& scene, const std::string& id);

}  // namespace isolux::ui
