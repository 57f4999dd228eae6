// What the program and its readers say to each other; docs/developers/processes.md, "Parser processes", has
// the whole exchange.
//
// A message is kMessageMark, its kind and the length of its body (8 bytes each), then the body. Bulk data
// (voxels, triangles, pixels) go through memory that both share. decode...() believe nothing: they throw
// base::Error{input} unless sizes, counts and matrices make sense by themselves.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "base/error.h"
#include "volume/mesh/triangle_mesh.h"
#include "volume/read/dicom/dicom_series.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/image_header.h"

namespace isolux::volume {

inline constexpr std::uint64_t kMessageMark =
    0x35525855'4c4f5349;  // "ISOLUXR5": the last digit is the version
inline constexpr std::size_t kMessageHeadBytes = 24;
inline constexpr std::uint64_t kLongestMessage = std::uint64_t{64} << 20;

enum class MessageKind : std::uint64_t {
  request = 1,
  goOn,      // program: the shared memory has the size asked for
  progress,  // reader: a fraction
  file,      // reader: the one it reads from here on
  failure,   // reader: a base::Error; its last word
  volume,    // reader: a DecodedVolume without its voxels
  mesh,      // reader: counts of a mesh
  image,     // reader: size of an image
  text,      // reader: versions of its libraries; its last word
  series,    // reader: a DicomSeries that it has found, or knows more of
  chunks,    // reader: an Hdf5Layout (volume/read/hdf5/hdf5_layout.h) without its table of chunks
  index,     // reader: a DicomIndexEnd, when it has looked at all files; its last word
  done       // reader: the shared memory is filled; its last word
};

// contour: of samples that the program puts into the shared memory.
// index: of the DICOM series of a folder; preview: a small image of one frame of a DICOM file; chunks: where
// those of an HDF5 dataset (`series`) lie.
enum class Task : std::uint64_t { volume = 1, mesh, image, versions, contour, index, preview, chunks };

struct Request {
  Task task = Task::volume;
  std::string path;
  ReadOptions options = {};            // of which series, component, timeStep and budgetBytes are sent
  std::vector<std::string> skip = {};  // files that an index passes by
  glm::ivec3 contourDims{0};  // of a contour's samples: float32, x fastest; the surface is where they are 0
  int parent = 0;             // process number of the program: a reader must not outlive it
};

// A volume as a file has it: what finishVolume() takes, and what only some formats know.
struct DecodedVolume {
  ImageHeader header;  // payload unused
  FileVoxels voxels;   // of the chosen component and time step
  std::string name;
  std::vector<std::string> seriesChoices;
  Patient patient;
};

// Linear RGB, row by row, row 0 at the top.
struct DecodedImage {
  int width = 0, height = 0;
  std::vector<glm::vec3> pixels;
};
inline constexpr std::int64_t kMostImagePixels = std::int64_t{1} << 27;  // 16384 x 8192

std::string encode(const Request& request);
Request decodeRequest(std::string_view body);

std::string encode(const base::Error& error);
base::Error decodeError(std::string_view body);

std::string encode(const DecodedVolume& volume);
std::string encode(const TriangleMesh& mesh);
std::string encode(const DecodedImage& image);
std::string encode(const DicomSeries& series);
std::string encode(const DicomIndexEnd& end);

// What the shared memory will hold is announced, not there yet: `voxels` is empty, of its type.
struct MeshCounts {
  std::uint64_t points = 0, triangles = 0;
};
struct ImageSize {
  int width = 0, height = 0;
};
DecodedVolume decodeVolume(std::string_view body);
MeshCounts decodeMesh(std::string_view body);
ImageSize decodeImage(std::string_view body);
DicomSeries decodeSeries(std::string_view body);
DicomIndexEnd decodeIndexEnd(std::string_view body);

// Bytes of shared memory for what is announced.
std::uint64_t bulkBytes(const DecodedVolume& announced);
std::uint64_t bulkBytes(const MeshCounts& announced);
std::uint64_t bulkBytes(const ImageSize& announced);

}  // namespace isolux::volume
