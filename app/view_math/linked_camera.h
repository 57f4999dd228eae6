// The camera of one window, taken over by another one that shows another volume: to compare patients or
// times.
#pragma once

#include "scene/rules/automatic.h"
#include "scene/scene.h"

namespace isolux::app {

// How the second volume is seen as the first one is; facts of both. No errors; any thread.
//
// Where both say where the patient lies and lie in the same place (each middle in the other's box), the
// camera is the same in mm: the same patient at two times. Where both say it but lie elsewhere, it is moved
// by what lies between the middles of their boxes: the same direction and the same scale, so that sizes
// compare. Else the distances are also in the ratio of the boxes' diagonals: both fill the picture alike.
// `camera` has eye, target and up.
scene::Camera linkedCamera(scene::Camera camera, const scene::VolumeFacts& first,
                           const scene::VolumeFacts& second);

}  // namespace isolux::app
