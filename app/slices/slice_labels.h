// What stands on a slice beside its values: the ends of the picture's axes, a ruler, and in words what it
// shows.
#pragma once

#include <string>
#include <vector>

#include "app/slices/slice_content.h"
#include "render/graph/frame.h"
#include "scene/world_axes.h"

namespace isolux::app {

// Which end of a world axis lies nearest to each side: letters of anatomy only where the file states them.
struct SliceLetters {
  std::string left, right, top, bottom;
  bool operator==(const SliceLetters&) const = default;
};
SliceLetters lettersOf(const volume::SlicePlane& plane, scene::WorldAxes axes);

// "axial · S 12.5 mm", "XZ · y = −3 mm" where no anatomy is stated, or three lines of an oblique
// plane: its middle and its normal.
std::string placeText(const volume::SlicePlane& plane, scene::WorldAxes axes);
// "radiological", "neurological"; "orientation not stated".
std::string conventionText(scene::Convention convention, scene::WorldAxes axes);
// "level 40 · width 400 HU", and the slab: "mean of 5 mm".
std::string windowText(const SliceContent& content, const scene::Slice& slice, const std::string& unit);

// A length of the picture to draw a ruler of.
struct Ruler {
  double mm = 0.0, pixels = 0.0;
  std::string text;  // "50 mm"
};
Ruler rulerOf(const volume::SlicePlane& plane);  // about a fifth of the width; a round number

// Writes all that onto the picture, as large as its height allows, bright on a dark rim. Pictures lower than
// 160 pixels have the letters alone, those lower than 48 nothing. `pixelRatio`: how many pixels are one of a
// screen at 100 %; texts are no smaller than they are there.
struct SliceWords {
  SliceLetters letters;
  std::string place, convention, window;
  Ruler ruler;
};
void drawWords(const SliceWords& words, render::ColorImage& image, double pixelRatio = 1.0);

}  // namespace isolux::app
