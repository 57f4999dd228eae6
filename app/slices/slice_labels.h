// What stands on a slice beside its values: the ends of the picture's axes, a ruler, and in words what it
// shows.
#pragma once

#include <string>
#include <vector>

#include "app/overlay_text/annotation.h"
#include "app/overlay_text/free_places.h"
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
// Returns whether the slice shows the patient's left and right, which the convention orders: not if sagittal.
bool showsLeftAndRight(const SliceLetters& letters);
// "level 40 · width 400 HU", and the slab: "mean of 5 mm".
std::string windowText(const SliceContent& content, const scene::Slice& slice, const std::string& unit);

ScaleBar rulerOf(const volume::SlicePlane& plane);  // about a fifth of the width; a round number

struct SliceWords {
  SliceLetters letters;
  std::string place, convention, window;  // no convention where it makes no difference
  ScaleBar ruler;
  std::vector<ShownValue> key;  // of the curves that are drawn
};
SliceWords wordsOf(const SliceContent& content, const volume::SlicePlane& plane, const scene::Slice& slice,
                   const volume::Volume& volume);

// Arranges all that stands in a picture of this size, as large as it allows: what is too wide is broken
// between words, and a letter that would touch a text stands beside it on its edge. The key stands at the
// upper right, else below what is there; where it has no room it is left out. Pictures with a side below 160
// pixels have the letters alone, those below 48 nothing. `pixelRatio`: how many pixels are one of a screen at
// 100 %; texts are no smaller than they are there.
struct WrittenText {
  std::string text;
  TextBox box;  // down to the baseline
};
struct SliceWordPlaces {
  std::vector<WrittenText> letters;  // left, right, top, bottom
  std::vector<WrittenText> texts;
  std::vector<WrittenText> key;  // the boxes with the samples of colours, squares as high as the text
};
SliceWordPlaces placesOf(const SliceWords& words, glm::ivec2 size, double pixelRatio = 1.0);
// How wide the strips at the picture's sides are, and how high those at its top and bottom, that the letters
// stand in.
glm::dvec2 letterBorder(const SliceLetters& letters, glm::ivec2 size, double pixelRatio);

// Writes it there, bright on a dark rim.
void drawWords(const SliceWords& words, render::ColorImage& image, double pixelRatio = 1.0);

}  // namespace isolux::app
