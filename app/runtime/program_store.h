// Chooses where linked OpenGL programs are stored: the folder `programs` of the user's cache.
#pragma once

#include <filesystem>

namespace isolux::app {

// Empty if the user has no home folder.
std::filesystem::path programFolder();

// Stores programs of this process (render/gl/program_cache.h). Called by main() and by the Python module, so
// that tests that run commands in their own process leave the user's cache alone.
void storePrograms();

}  // namespace isolux::app
