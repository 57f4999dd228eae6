// The page directories of TIFF and BigTIFF files, and the files of a folder in natural order ("2" before
// "10").
//
// Pixels are decoded by libtiff (readers/images), which knows the compressions; before it sees a file, the
// walk over the page directories here checks sizes against the file. Throws base::Error{input}.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "volume/read/input/bytes.h"

namespace isolux::volume {

// Numbers as in the TIFF 6.0 specification.
struct TiffPage {
  int index = 0;                // in the file
  std::uint64_t directory = 0;  // byte
  std::int64_t width = 0, height = 0, samples = 1, bits = 1;
  std::int64_t sampleFormat = 1, photometric = 1, compression = 1, orientation = 1;
  std::uint64_t pixels = 0;  // byte of the first strip or tile
  bool contiguous = false;   // strips that follow one another, not compressed
  bool sameLayoutAs(const TiffPage& other) const {
    return width == other.width && height == other.height && samples == other.samples && bits == other.bits &&
           sampleFormat == other.sampleFormat;
  }
  std::uint64_t rawBytes() const {  // of its pixels, decoded; rows are padded to bytes
    return static_cast<std::uint64_t>((width * samples * bits + 7) / 8 * height);
  }
};

// What the first page says beside its pixels.
struct TiffStatements {
  std::string description;
  double xResolution = 0.0, yResolution = 0.0;  // pixels per unit; 0: not stated
  int resolutionUnit = 2;                       // 1 none, 2 inch, 3 cm
  std::string noData, gdalMetadata;             // GDAL_NODATA, GDAL_METADATA
  std::int64_t uicPlanes = 0;                   // of a MetaMorph stack, whose planes share one page
  std::vector<std::byte> lsmInfo;               // Zeiss LSM, the first 64 bytes, in the file's byte order
  std::vector<std::string> unreadRecords;       // names of other programs' records
};

struct TiffFile {
  std::vector<TiffPage> pages;  // of full resolution; at least one
  TiffStatements says;
  bool bigEndian = false;
};

bool looksLikeTiff(std::string_view head);
// Throws for directories that lead nowhere or claims the file cannot hold.
TiffFile tiffPages(const Bytes& bytes, const base::Progress& progress);

// "slice2" before "slice10": runs of digits compare as numbers.
bool naturalLess(std::string_view a, std::string_view b);
// TIFF files of a folder, in natural order.
std::vector<std::filesystem::path> tiffFilesIn(const std::filesystem::path& folder);

}  // namespace isolux::volume
