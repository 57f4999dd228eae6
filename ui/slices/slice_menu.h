// The menu of a slice: which plane it shows, level and width for kinds of tissue, thick slab, convention.
#pragma once

class QMenu;

namespace isolux::ui {

class SliceView;

// Each entry of it is one step of undo, or chooses the view's plane, which is none. The view has a volume.
// Windows for tissues are there where values are in HU, the convention where anatomy is stated.
QMenu* makeSliceMenu(SliceView& view);

}  // namespace isolux::ui
