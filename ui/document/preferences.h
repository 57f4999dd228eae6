// Stores a user's preferences between runs: host settings (scene/settings/host_settings.h) and how the window
// looks.
#pragma once

#include "scene/settings/host_settings.h"
#include "ui/theme/theme.h"

namespace isolux::ui {

// What was kept; the defaults where nothing was, or nothing that fits.
scene::HostSettings savedHostSettings();
// Keeps a setting whose value has changed. One that has its default is forgotten, so that a later version's
// default applies.
void saveHostSettings(const scene::HostSettings& before, const scene::HostSettings& after);

// dark where nothing was kept.
Theme savedTheme();
void keepTheme(Theme theme);
// Per cent, smallestScale to largestScale (ui/theme/theme.h).
int savedScale();
void keepScale(int percent);

}  // namespace isolux::ui
