// Files that other people's libraries parse: each in a reader, a process of its own (reader_process.h).
//
// Here is which format goes where, and what becomes of the answer. Throws base::Error (input, memory, usage,
// interrupted).
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "volume/read/input/read_options.h"
#include "volume/read/process/reader_process.h"
#include "volume/volume.h"

namespace isolux::volume {

// VTK XML image data (.vti); TIFF, a file or a folder; DICOM, a file or a folder.
Volume readVti(const std::filesystem::path& path, const ReadOptions& options, base::Progress& progress);
Volume readTiff(const std::filesystem::path& path, const ReadOptions& options, base::Progress& progress);
Volume readDicom(const std::filesystem::path& path, const ReadOptions& options, base::Progress& progress);

// VTK XML PolyData (.vtp). All points are finite and all indices in range. `program`: the reader.
TriangleMesh readPolyDataMesh(const std::filesystem::path& path, std::size_t budgetBytes,
                              base::Progress& progress,
                              const std::filesystem::path& program = readerProgram("isolux-reader-vtk"));

// A flat image of one channel (grey) or more, as linear RGB (any format OpenImageIO knows).
DecodedImage readImage(const std::filesystem::path& path, base::Progress& progress,
                       const std::filesystem::path& program = readerProgram("isolux-reader-images"));

// Not a file, but VTK's as well: triangles where samples (x fastest, written by `fill`) pass 0; inside is at
// least 0. Voxel coordinates, turned all the same way. budgetBytes: of the triangles.
TriangleMesh contour(glm::ivec3 dims, const std::function<void(std::span<float>)>& fill,
                     std::size_t budgetBytes, base::Progress& progress);

// "VTK 9.1.0", ...: what each reader reports, or why it cannot be asked. For `isolux doctor`.
std::vector<std::string> readerVersions(base::Progress& progress);

// The steps of the first three with any program in the reader's place.
Volume readVolumeBy(const std::filesystem::path& program, const std::filesystem::path& path,
                    const ReadOptions& options, base::Progress& progress, double patienceSeconds = 30.0);
DecodedImage receivedImage(ReaderProcess& reader);  // that was asked for one

}  // namespace isolux::volume
