#include "volume/read/process/foreign.h"

#include <cmath>

#include "base/error.h"
#include "volume/read/input/payload.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

constexpr const char* vtkReader = "isolux-reader-vtk";
constexpr const char* dicomReader = "isolux-reader-dicom";
constexpr const char* imageReader = "isolux-reader-images";
constexpr const char* surfaceReader = "isolux-reader-surface";
constexpr const char* hdf5Reader = "isolux-reader-hdf5";

// What the reader says about a mesh it has read is not believed either.
void checkMesh(const TriangleMesh& mesh, const fs::path& path) {
  const auto count = static_cast<std::int64_t>(mesh.points.size());
  constexpr double farthest = 1e12;  // mm, as for volumes
  for (const glm::dvec3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(p[axis]) <= farthest))
        base::throwInput(path.string(), "points", "a coordinate is not finite or beyond 1e12 mm");
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] < 0 || t[i] >= count)
        base::throwInput(path.string(), "triangles", "a corner is not a point of the mesh");
}

TriangleMesh receiveMesh(ReaderProcess& reader, const fs::path& path) {
  const MeshCounts counts = reader.announced(MessageKind::mesh, decodeMesh);
  reader.receive(bulkBytes(counts));
  TriangleMesh mesh;
  mesh.points.resize(static_cast<std::size_t>(counts.points));
  mesh.triangles.resize(static_cast<std::size_t>(counts.triangles));
  const auto points = std::as_writable_bytes(std::span(mesh.points));
  reader.read(0, points);
  reader.read(points.size(), std::as_writable_bytes(std::span(mesh.triangles)));
  checkMesh(mesh, path);
  return mesh;
}

}  // namespace

Volume readVolumeBy(const fs::path& program, const fs::path& path, const ReadOptions& options,
                    base::Progress& progress, double patienceSeconds) {
  progress.report(0.0, "reading");
  ReaderProcess reader(program, {.task = Task::volume, .path = path.string(), .options = options}, progress,
                       patienceSeconds);
  DecodedVolume decoded = reader.announced(MessageKind::volume, decodeVolume);
  checkChoices(decoded.header, path.string(), options);
  reader.receive(bulkBytes(decoded));
  std::visit(
      [&](auto& voxels) {
        voxels.resize(static_cast<std::size_t>(decoded.header.voxels()));
        reader.read(0, std::as_writable_bytes(std::span(voxels)));
      },
      decoded.voxels);
  reader.forgetMemory();  // before the conversion allocates
  Volume volume = finishVolume(decoded.header, std::move(decoded.voxels), options, progress);
  volume.name = decoded.name;
  volume.seriesChoices = std::move(decoded.seriesChoices);
  rememberPatient(volume.grid, decoded.patient);
  return volume;
}

TriangleMesh readPolyDataMesh(const fs::path& path, std::size_t budgetBytes, base::Progress& progress,
                              const fs::path& program) {
  Request request{.task = Task::mesh, .path = path.string()};
  request.options.budgetBytes = budgetBytes;
  ReaderProcess reader(program, request, progress);
  return receiveMesh(reader, path);
}

TriangleMesh contour(glm::ivec3 dims, const std::function<void(std::span<float>)>& fill,
                     std::size_t budgetBytes, base::Progress& progress) {
  Request request{.task = Task::contour, .path = "the surface", .contourDims = dims};
  request.options.budgetBytes = budgetBytes;
  const std::uint64_t count = Extent3{dims}.count();
  ReaderProcess reader(readerProgram(surfaceReader), request, progress);
  reader.lend(count * sizeof(float), [&](std::span<std::byte> bytes) {
    fill({reinterpret_cast<float*>(bytes.data()), static_cast<std::size_t>(count)});
  });
  return receiveMesh(reader, "the surface");
}

DecodedImage receivedImage(ReaderProcess& reader) {
  const ImageSize size = reader.announced(MessageKind::image, decodeImage);
  reader.receive(bulkBytes(size));
  DecodedImage image{size.width, size.height, {}};
  image.pixels.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  reader.read(0, std::as_writable_bytes(std::span(image.pixels)));
  return image;
}

DecodedImage readImage(const fs::path& path, base::Progress& progress, const fs::path& program) {
  ReaderProcess reader(program, {.task = Task::image, .path = path.string()}, progress);
  return receivedImage(reader);
}

Volume readVti(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
  return readVolumeBy(readerProgram(vtkReader), path, options, progress);
}

Volume readTiff(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
  return readVolumeBy(readerProgram(imageReader), path, options, progress);
}

Volume readDicom(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
  return readVolumeBy(readerProgram(dicomReader), path, options, progress);
}

std::vector<std::string> readerVersions(base::Progress& progress) {
  std::vector<std::string> lines;
  for (const char* name : {vtkReader, dicomReader, imageReader, surfaceReader, hdf5Reader}) {
    try {
      ReaderProcess reader(readerProgram(name), {.task = Task::versions, .path = name}, progress);
      lines.push_back(reader.expect(MessageKind::text));
    } catch (const base::Error& error) {
      if (error.kind() == base::ErrorKind::interrupted) throw;
      lines.push_back(std::string(name) + ": " + error.reason());
    }
  }
  return lines;
}

}  // namespace isolux::volume
