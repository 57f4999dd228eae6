// The names of the subcommands, for the launcher, which has no parser. A test compares them with the
// parser's.
#pragma once

namespace isolux::app {

inline constexpr const char* kCommandNames[] = {
    "info",    "render", "bake", "merge",   "index",   "reference", "replay", "study", "probe",
    "measure", "slice",  "mesh", "phantom", "presets", "settings",  "doctor", "help"};

}  // namespace isolux::app
