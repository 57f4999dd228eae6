// The reader's end of the exchange with the program (volume/read/process/reader_messages.h): takes one
// request, lets a library parse the file, hands over what came of it, and ends.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "volume/read/hdf5/hdf5_layout.h"
#include "volume/read/process/reader_messages.h"

namespace isolux::readers {

// A dataset and where its chunks lie.
struct Hdf5Table {
  volume::Hdf5Layout layout;
  std::vector<volume::Hdf5Chunk> chunks;  // layout.chunkCount() of them
};

// What a reader can do; null for what it cannot. They throw base::Error; any other exception is taken as
// damage to the file.
struct Abilities {
  volume::DecodedVolume (*volume)(const std::filesystem::path&, const volume::ReadOptions&,
                                  base::Progress&) = nullptr;
  volume::TriangleMesh (*mesh)(const std::filesystem::path&, base::Progress&) = nullptr;
  // Of samples (x fastest) where they pass 0; inside is at least 0. Voxel coordinates, seen from outside
  // counter-clockwise.
  volume::TriangleMesh (*contour)(std::span<const float> samples, glm::ivec3 dims, base::Progress&) = nullptr;
  volume::DecodedImage (*image)(const std::filesystem::path&, base::Progress&) = nullptr;
  // The series of a folder, each told as often as more of it is known; a picture of a file's frame.
  volume::DicomIndexEnd (*index)(const std::filesystem::path& folder, const std::vector<std::string>& skip,
                                 const std::function<void(const volume::DicomSeries&)>& found,
                                 base::Progress&) = nullptr;
  volume::DecodedImage (*preview)(const std::filesystem::path&, const volume::ReadOptions&,
                                  base::Progress&) = nullptr;
  // Of an HDF5 file, the dataset options.series or else the largest; in the order of C arrays.
  Hdf5Table (*chunks)(const std::filesystem::path&, const volume::ReadOptions&, base::Progress&) = nullptr;
  std::string (*versions)() = nullptr;
};

// Tells the program which of many files is read from here on, so that it can name the one that ends the
// reader.
void nowReading(const std::filesystem::path& file);

// The whole of a reader's main(): its exit code.
int serve(const Abilities& abilities);

}  // namespace isolux::readers
