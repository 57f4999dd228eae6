// What study.md says of the knobs of hits and derivatives, and of those of the picture alone.
#pragma once

#include <iosfwd>

#include "app/study/study_results.h"

namespace isolux::app {

// One table, and for a field a second one against `cubic_interpolating`.
void writeSurfaceTables(std::ostream& out, const KnobStudy& study);
// Of rays per pixel, or the shadow.
void writePictureTable(std::ostream& out, const KnobStudy& study);

}  // namespace isolux::app
