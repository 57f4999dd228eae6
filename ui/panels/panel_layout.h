// How the settings panel is organised: which group a setting stands in, in which order, under which name.
//
// Every setting that a user edits in the panel stands in exactly one group. A setting that is not named here
// appears at the end of the group that takes its prefix, or in a group of its own.
#pragma once

#include <vector>

#include <QString>

#include "scene/settings/settings.h"

namespace isolux::ui {

// The title of the group that also shows the light probe (ui/editors/environment_preview.h).
inline constexpr const char* environmentGroup = "Environment";

struct PanelGroup {
  QString title;
  bool open;  // at first
  std::vector<const scene::Setting*> settings;
};

// Without the source, which the volume panel edits.
std::vector<PanelGroup> panelGroups();

// "look.tone_cool" -> "Tone cool"; `indented`: a detail of the row above.
struct RowLabel {
  QString text;
  bool indented;
};
RowLabel labelOf(const scene::Setting& setting);

}  // namespace isolux::ui
