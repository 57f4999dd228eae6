// Where the files of shared pictures lie on this machine.
//
// A picture that is given away should not tell the names of folders, which often are those of users and
// patients. It names a file and a token instead: random digits that mean something only here, where the
// user's state folder (app/files/state_folder.h) remembers which path they stand for: places.json, an array
// of
// ["token", "/path"], the one used last at the end.
//
// Any thread; several processes at once.
#pragma once

#include <filesystem>
#include <string>

namespace isolux::app {

// The token of an absolute path, always the same one. "" when it cannot be remembered.
std::string placeToken(const std::filesystem::path& file);
// The path that a token stands for; "" when this machine does not know it, or nothing is there any more.
std::filesystem::path placeOf(const std::string& token);

}  // namespace isolux::app
