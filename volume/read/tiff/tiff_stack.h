// What a TIFF file says its pages are: channels, slices and frames, their distances, what numbers mean.
//
// Read are the descriptions of ImageJ (key=value lines), OME-TIFF (XML) and tifffile (JSON), Zeiss LSM's
// record, and GDAL's scale, offset and no-data value. A file without them is a stack of slices; TIFF itself
// has no distance of slices. Throws base::Error{input}.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/read/tiff/tiff_pages.h"

namespace isolux::volume {

struct TiffStack {
  std::int64_t channels = 1, slices = 1, frames = 1;  // channels: of pages; each may have several samples
  // Index into the pages, slice fastest, then channel, then frame. Of planes that share one page: their
  // number.
  std::vector<std::size_t> planes;
  bool inOnePage = false;  // the planes follow one another from the first page's pixels on
  glm::dvec3 spacingMm{1.0};
  double slope = 1.0, intercept = 0.0;
  std::string unit;              // of values
  std::optional<double> noData;  // stored number that means: none
  std::vector<std::string> warnings;

  std::size_t plane(std::int64_t channel, std::int64_t slice, std::int64_t frame) const {
    return planes[static_cast<std::size_t>((frame * channels + channel) * slices + slice)];
  }
};

// Of the pages of `file`, which all have one layout. `name`: of the file, for errors.
TiffStack tiffStackOf(const TiffFile& file, const std::string& name, std::uint64_t fileBytes);

}  // namespace isolux::volume
