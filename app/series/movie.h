// Numbered pictures as a movie, by ffmpeg where it is found.
#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"

namespace isolux::app {

// The pictures `prefix`00000.png, `prefix`00001.png, ... of a folder as the file `movie` in it. A movie is an
// extra: without a working ffmpeg nothing is written, and what is returned says why, for a note; else empty.
// Throws base::Error{interrupted}.
std::string makeMovie(const std::filesystem::path& folder, const std::string& prefix, int frames, double fps,
                      const std::string& movie, base::Progress& progress);

}  // namespace isolux::app
