// What the user's machine is asked for (scene/machine.h), kept for this user between runs.
#pragma once

#include "scene/machine.h"

namespace isolux::ui {

// What was kept; the defaults where nothing was, or nothing that fits.
scene::Machine keptMachine();
// Keeps a setting whose value has changed. One that has its default is forgotten, so that a later version's
// default applies.
void keepMachine(const scene::Machine& before, const scene::Machine& after);

}  // namespace isolux::ui
