// The menu of a slice: one more isosurface, which plane it shows, level and width for kinds of tissue, thick
// slab, convention.
#pragma once

#include <glm/vec3.hpp>

class QMenu;

namespace isolux::ui {

class SliceView;

// Each entry of it is one step of undo, or chooses the view's plane, which is none. The view has a volume.
// Windows for tissues are there where values are in HU, the convention where anatomy is stated.
// `worldMm`: the point of the slice that the menu is asked for.
QMenu* makeSliceMenu(SliceView& view, glm::dvec3 worldMm);

}  // namespace isolux::ui
