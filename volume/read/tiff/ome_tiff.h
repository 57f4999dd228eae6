// OME-XML in the description of a TIFF file (https://docs.openmicroscopy.org/ome-model): the first image's
// sizes, distances and pages.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace isolux::volume {

struct OmeTiff {
  bool known = false;  // false: the XML describes no pixels of this file, as a warning says
  std::int64_t width = 1, height = 1, slices = 1, channels = 1, frames = 1;
  std::string order = "XYCZT";  // of planes, the fastest first
  std::array<std::optional<double>, 3> spacing;
  std::array<std::string, 3> units{"\u00b5m", "\u00b5m", "\u00b5m"};

  struct Planes {  // a TiffData element
    std::optional<std::int64_t> directory, count;
    std::int64_t slice = 0, channel = 0, frame = 0;
    std::string file;  // "": not named
  };
  std::vector<Planes> planes;
  std::string elsewhere;  // a file that holds other planes
  std::vector<std::string> warnings;

  // The page directory of each plane, slice fastest, then channel of `pageChannels`, then frame; -1: none is
  // named. Requires that `pageChannels` divides `channels`.
  std::vector<std::int64_t> directories(std::int64_t pageChannels) const;
};

// `name`: of the file, for errors. Throws base::Error{input} for damaged XML and absurd sizes.
OmeTiff parseOmeTiff(const std::string& xml, const std::string& name);

}  // namespace isolux::volume
