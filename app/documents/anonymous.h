// Texts without what tells who the patient is. No errors; any thread.
//
// Hidden are the words of the name, the id and the birth date, in the ways in which they are written; each is
// shown as "anonymous". Other things that may tell a person (a face, a rare scan, what somebody wrote about
// them) stay.
#pragma once

#include <string>

#include "scene/scene.h"
#include "volume/read/input/patient.h"

namespace isolux::app {

inline constexpr auto kAnonymous = "anonymous";

// Words of the name of two or three letters only as whole words, longer ones and the id (of three letters or
// more) wherever they stand, all whatever the case; the birth date as YYYYMMDD, YYYY-MM-DD and DD.MM.YYYY.
std::string withoutPatient(const std::string& text, const volume::Patient& patient);

// Names of marks. Paths of files stay: they lead to the data.
scene::Scene withoutPatient(scene::Scene scene, const volume::Patient& patient);

}  // namespace isolux::app
