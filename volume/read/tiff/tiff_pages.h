// TIFF stacks: a file with several pages, or a folder of numbered files in natural order ("2" before "10").
//
// Decoded by OpenImageIO (readers/images), which knows the compressions; before it sees a file, our own walk
// over the page directories, here, checks sizes against the file. All full-resolution pages must agree in
// size and type. TIFF states no distance of slices: the spacing is 1 mm, with a warning. Throws
// base::Error{input}.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "volume/read/input/bytes.h"

namespace isolux::volume {

struct TiffPage {
  int index = 0;  // in the file
  std::int64_t width = 0, height = 0, samples = 1, bits = 1;
  bool sameLayoutAs(const TiffPage& other) const {
    return width == other.width && height == other.height && samples == other.samples && bits == other.bits;
  }
};

bool looksLikeTiff(std::string_view head);
// The full-resolution pages; throws for directories that lead nowhere or claims the file cannot hold.
std::vector<TiffPage> tiffPages(const Bytes& bytes, const base::Progress& progress);

// "slice2" before "slice10": runs of digits compare as numbers.
bool naturalLess(std::string_view a, std::string_view b);
// TIFF files of a folder, in natural order.
std::vector<std::filesystem::path> tiffFilesIn(const std::filesystem::path& folder);

}  // namespace isolux::volume
