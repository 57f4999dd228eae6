// Names that are proposed for files.
#pragma once

#include <string>

namespace isolux::app {

// What a volume, session or picture is called without its folder and format: "ct_head" of
// "/scans/ct_head.nii.gz" or "ct_head.isolux". A folder of slices keeps its whole name; "phantom:head:64" is
// "head". "" of "".
std::string plainName(const std::string& path);

}  // namespace isolux::app
