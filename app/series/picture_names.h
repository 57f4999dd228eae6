// The file names of several pictures, made from one pattern: {name} what the volume is called
// (app/files/file_names.h), {n} the volume's number on the command line from 1, {i} the picture's number in
// its series from 00000, {value} what is swept there, or the turntable's degrees.
#pragma once

#include <string>
#include <vector>

namespace isolux::app {

struct PictureOfSeries {
  std::string path;  // of the volume, as given
  int n = 1, i = 0;
  std::string value;  // empty: no series
};

// `pattern` as it is used for so many volumes and a series or none: as given where it tells the pictures
// apart, with "_{i}" before its extension where a series would otherwise write one file; a folder (no
// extension) holds "frame_{i}.png" of a series and "{name}.png" else, with several volumes "{name}_{i}.png".
std::string completePattern(const std::string& pattern, std::size_t volumes, bool series);

// Anything else in braces is part of the name.
std::string expandedName(const std::string& pattern, const PictureOfSeries& picture);

// Throws base::Error{usage} when two pictures would go into one file, naming it and what would tell them
// apart.
void checkNamesDiffer(const std::vector<std::string>& names, const std::string& option);

}  // namespace isolux::app
