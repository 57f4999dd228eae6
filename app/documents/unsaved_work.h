// Whether closing a document would lose work: decides if the window asks before it closes, quits or opens
// something else. Pure functions, any thread.
#pragma once

#include "scene/scene.h"

namespace isolux::app {

enum class UnsavedWork {
  none,  // the scene is as it was opened or saved
  view,  // only where it is seen from differs, the moment of an animated flow, and what stands on pictures
  work   // settings that were chosen: isovalue, look, light, source, ...
};
UnsavedWork unsavedWork(const scene::Scene& saved, const scene::Scene& now);

// A session file is kept up to date in everything. Of a document without one, a turned view alone is not
// worth a question: whoever has only looked around may leave.
bool asksBeforeDiscarding(UnsavedWork unsaved, bool hasSessionFile);

}  // namespace isolux::app
