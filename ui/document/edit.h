// What a widget sends when the user changes something: the whole edited Scene and the name of the change.
#pragma once

#include <QString>

#include "scene/scene.h"

namespace isolux::ui {

struct Edit {
  scene::Scene scene;
  QString name;           // for undo and recordings: "Rotate", "Set isovalue"
  QString mergeKey = {};  // edits with the same non-empty key are one undo step until the gesture ends
  // A gesture without a natural end (wheel, arrow keys, typing) ends after a pause.
  bool endsAfterPause = false;
};

}  // namespace isolux::ui
