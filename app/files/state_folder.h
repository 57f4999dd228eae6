// Where the program keeps what it knows between runs, apart from settings: $XDG_STATE_HOME/isolux, by default
// ~/.local/state/isolux (XDG Base Directory Specification).
#pragma once

#include <filesystem>

namespace isolux::app {

// Absolute; not made. Empty when the user has no home folder.
std::filesystem::path stateFolder();

// What the user chooses and may give away, beside settings: $XDG_CONFIG_HOME/isolux, by default
// ~/.config/isolux. As above.
std::filesystem::path configFolder();

// Returns the folder of what can be computed again: $XDG_CACHE_HOME/isolux, by default ~/.cache/isolux. Empty
// as above.
std::filesystem::path cacheFolder();

// Makes the folder, for the user's eyes only, where it is missing: what is kept names patients' files. Throws
// base::Error{input}.
void makePrivateFolder(const std::filesystem::path& folder);

}  // namespace isolux::app
