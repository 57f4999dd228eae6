// What is kept for this user between runs: what the machine is asked for (scene/settings/machine.h), and how
// the window looks.
#pragma once

#include "scene/settings/machine.h"
#include "ui/theme/theme.h"

namespace isolux::ui {

// What was kept; the defaults where nothing was, or nothing that fits.
scene::Machine keptMachine();
// Keeps a setting whose value has changed. One that has its default is forgotten, so that a later version's
// default applies.
void keepMachine(const scene::Machine& before, const scene::Machine& after);

// dark where nothing was kept.
Theme keptTheme();
void keepTheme(Theme theme);
// Per cent, smallestScale to largestScale (ui/theme/theme.h).
int keptScale();
void keepScale(int percent);

}  // namespace isolux::ui
