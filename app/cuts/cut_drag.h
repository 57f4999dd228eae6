// What dragging a handle of a cut does. Pure functions of where the drag began and where it is, so that any
// way of the pointer between the two leads to the same cut.
#pragma once

#include "app/cuts/cut_handles.h"

namespace isolux::app {

// The cut after `grip` of `clip`, the cut at the drag's beginning, was dragged from one pixel to another.
// A plane stays within the volume; what has its normal near the line of sight moves by the pointer's height,
// up is away from the viewer. A face of the box leaves the opposite one where it is. What turns does so on a
// ball: a plane's arrow about its knob, a corner of the box about the box's middle. `constrained`: a plane's
// normal goes to the nearest world axis or halfway between two, the box turns about one of its own axes.
scene::Clip draggedCut(const scene::Clip& clip, const CutGrip& grip, const CutStage& stage, glm::dvec2 from,
                       glm::dvec2 to, bool constrained);

// A plane, or a face of the box, `mm` along its normal, above 0 away from the viewer; other grips do not
// move.
scene::Clip steppedCut(const scene::Clip& clip, const CutGrip& grip, const CutStage& stage, double mm);

// Whether the grip is one of this cut.
bool hasGrip(const scene::Clip& clip, const CutGrip& grip);

}  // namespace isolux::app
