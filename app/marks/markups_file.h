// Marks as Markups JSON of 3D Slicer (.mrk.json), written and read.
//
// Each mark is a markup of its own: Line of two points, Curve of a path and of a distance of more, Angle of
// three points, Fiducial of all else. What Slicer has no type for is told by a key of our own, "isolux":
// {"kind": ...}, which it passes over; without that key each point of a Fiducial is a pin, and a ClosedCurve
// a path that ends where it begins. Positions are written in LPS mm; RAS is read, too. Format: Slicer,
// Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace isolux::app {

// World mm as LPS. Names, points, colours (as a screen shows them) and visibility.
std::string markupsText(std::span<const scene::Mark> marks);

struct ReadMarks {
  std::vector<scene::Mark> marks;
  std::vector<std::string> notes;  // what was left out: planes, regions, points that are not set
};
// `file` names it in errors. Throws base::Error{input} with the place of the fault.
ReadMarks parseMarkups(const std::string& text, const std::string& file);
ReadMarks readMarkups(const std::filesystem::path& file);

}  // namespace isolux::app
