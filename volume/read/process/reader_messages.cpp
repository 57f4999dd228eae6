#include "volume/read/process/reader_messages.h"

#include <array>
#include <limits>

#include "volume/read/process/wire.h"

namespace isolux::volume {

namespace {

constexpr std::size_t mostWarnings = 10000, mostSeries = 1000000, mostSkippedFiles = 1000;
constexpr std::uint64_t mostPoints = std::uint64_t{1} << 31, mostTriangles = std::uint64_t{1} << 30;

VoxelType typeOf(const FileVoxels& voxels) {
  return static_cast<VoxelType>(voxels.index());
}

void putPatient(WireWriter& wire, const Patient& patient) {
  for (const std::string* text : {&patient.name, &patient.id, &patient.birthDate})
    wire.put(std::string_view(*text));
}

Patient takePatient(WireReader& wire) {
  Patient patient;
  for (std::string* text : {&patient.name, &patient.id, &patient.birthDate}) *text = wire.text();
  return patient;
}

// The texts of a series, in the order in which they are sent.
template <class Series>
auto textsOf(Series& series) {
  return std::array{&series.study,    &series.studyDescription, &series.studyDate,
                    &series.series,   &series.description,      &series.date,
                    &series.modality, &series.kernel,           &series.number,
                    &series.folder,   &series.problem,          &series.middleFile};
}

}  // namespace

std::string encode(const Request& request) {
  WireWriter wire;
  wire.put(static_cast<std::uint64_t>(request.task));
  wire.put(std::string_view(request.path));
  wire.put(std::string_view(request.options.series));
  wire.put(static_cast<std::int64_t>(request.options.component));
  wire.put(static_cast<std::int64_t>(request.options.timeStep));
  wire.put(static_cast<std::uint64_t>(request.options.budgetBytes));
  wire.put(request.skip);
  for (int axis = 0; axis < 3; ++axis) wire.put(static_cast<std::int64_t>(request.contourDims[axis]));
  wire.put(static_cast<std::int64_t>(request.parent));
  return wire.bytes();
}

Request decodeRequest(std::string_view body) {
  WireReader wire(body);
  Request request;
  request.task = static_cast<Task>(wire.number(1, static_cast<std::uint64_t>(Task::chunks)));
  request.path = wire.text();
  request.options.series = wire.text();
  request.options.component = static_cast<int>(static_cast<std::int64_t>(wire.number()));
  request.options.timeStep = static_cast<int>(static_cast<std::int64_t>(wire.number()));
  request.options.budgetBytes = static_cast<std::size_t>(wire.number());
  request.skip = wire.texts(mostSkippedFiles);
  for (int axis = 0; axis < 3; ++axis) request.contourDims[axis] = static_cast<int>(wire.number(0, 1u << 24));
  request.parent = static_cast<int>(wire.number());
  wire.end();
  return request;
}

std::string encode(const base::Error& error) {
  WireWriter wire;
  wire.put(static_cast<std::int64_t>(error.kind()));
  wire.put(std::string_view(error.file()));
  wire.put(std::string_view(error.place()));
  wire.put(std::string_view(error.reason()));
  return wire.bytes();
}

base::Error decodeError(std::string_view body) {
  using base::ErrorKind;
  WireReader wire(body);
  const auto kind = static_cast<ErrorKind>(wire.number(2, 5));
  if (kind == ErrorKind::graphics) throwBadAnswer("a kind of error that no file has");
  const std::string file = wire.text(), place = wire.text(), reason = wire.text();
  wire.end();
  return base::Error(kind, file, place, reason);
}

std::string encode(const DecodedVolume& volume) {
  const ImageHeader& header = volume.header;
  WireWriter wire;
  wire.put(std::string_view(header.format));
  wire.put(static_cast<std::uint64_t>(header.type));
  for (const std::int64_t axis : header.dims) wire.put(axis);
  wire.put(header.components);
  wire.put(header.timeSteps);
  wire.put(header.worldFromVoxel);
  wire.put(static_cast<std::uint64_t>(header.axes));
  wire.put(header.slope);
  wire.put(header.intercept);
  wire.put(std::string_view(header.unit));
  wire.put(header.warnings);
  wire.put(std::string_view(volume.name));
  wire.put(volume.seriesChoices);
  putPatient(wire, volume.patient);
  wire.put(static_cast<std::uint64_t>(typeOf(volume.voxels)));
  return wire.bytes();
}

DecodedVolume decodeVolume(std::string_view body) {
  constexpr auto lastType = static_cast<std::uint64_t>(VoxelType::float64);
  constexpr auto lastAxes = static_cast<std::uint64_t>(scene::WorldAxes::anatomical);
  constexpr std::uint64_t mostSteps = std::uint64_t{1} << 31;
  WireReader wire(body);
  DecodedVolume volume;
  ImageHeader& header = volume.header;
  header.format = wire.text();
  header.type = static_cast<VoxelType>(wire.number(0, lastType));
  for (std::int64_t& axis : header.dims) axis = static_cast<std::int64_t>(wire.number(1, 65535));
  header.components = static_cast<std::int64_t>(wire.number(1, mostSteps));
  header.timeSteps = static_cast<std::int64_t>(wire.number(1, mostSteps));
  header.worldFromVoxel = wire.finiteMatrix();
  header.axes = static_cast<scene::WorldAxes>(wire.number(0, lastAxes));
  header.slope = wire.real();  // 0 and NaN have a meaning
  header.intercept = wire.real();
  header.unit = wire.text();
  header.warnings = wire.texts(mostWarnings);
  volume.name = wire.text();
  volume.seriesChoices = wire.texts(mostSeries);
  volume.patient = takePatient(wire);
  const auto type = static_cast<VoxelType>(wire.number(0, lastType));
  wire.end();
  if (!usableAffine(header.worldFromVoxel)) throwBadAnswer("spacing or orientation is degenerate");
  checkDims(header, "", "answer of the reader");
  withType(type, [&](auto zero) { volume.voxels = std::vector<decltype(zero)>(); });
  return volume;
}

std::string encode(const TriangleMesh& mesh) {
  WireWriter wire;
  wire.put(static_cast<std::uint64_t>(mesh.points.size()));
  wire.put(static_cast<std::uint64_t>(mesh.triangles.size()));
  return wire.bytes();
}

MeshCounts decodeMesh(std::string_view body) {
  WireReader wire(body);
  MeshCounts counts;
  counts.points = wire.number(0, mostPoints);
  counts.triangles = wire.number(0, mostTriangles);
  wire.end();
  return counts;
}

std::string encode(const DecodedImage& image) {
  WireWriter wire;
  wire.put(static_cast<std::int64_t>(image.width));
  wire.put(static_cast<std::int64_t>(image.height));
  return wire.bytes();
}

ImageSize decodeImage(std::string_view body) {
  WireReader wire(body);
  const std::uint64_t width = wire.number(1, kMostImagePixels), height = wire.number(1, kMostImagePixels);
  wire.end();
  if (width * height > static_cast<std::uint64_t>(kMostImagePixels))
    throwBadAnswer("an image is larger than one may be");
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::string encode(const DicomSeries& series) {
  WireWriter wire;
  putPatient(wire, series.patient);
  for (const std::string* text : textsOf(series)) wire.put(std::string_view(*text));
  for (const std::int64_t number : {series.columns, series.rows, series.slices, series.timeSteps})
    wire.put(number);
  for (int axis = 0; axis < 3; ++axis) wire.put(series.spacingMm[axis]);
  wire.put(series.warnings);
  wire.put(static_cast<std::int64_t>(series.middleFrame));
  return wire.bytes();
}

DicomSeries decodeSeries(std::string_view body) {
  constexpr std::uint64_t most = std::uint64_t{1} << 31;
  WireReader wire(body);
  DicomSeries series;
  series.patient = takePatient(wire);
  for (std::string* text : textsOf(series)) *text = wire.text();
  for (std::int64_t* number : {&series.columns, &series.rows, &series.slices, &series.timeSteps})
    *number = static_cast<std::int64_t>(wire.number(0, most));
  for (int axis = 0; axis < 3; ++axis) series.spacingMm[axis] = wire.finite();
  series.warnings = wire.texts(mostWarnings);
  series.middleFrame = static_cast<int>(wire.number(0, 65535));
  wire.end();
  return series;
}

std::string encode(const DicomIndexEnd& end) {
  WireWriter wire;
  for (const std::int64_t number : {end.files, end.dicomFiles, end.unreadable}) wire.put(number);
  wire.put(std::string_view(end.firstReason));
  return wire.bytes();
}

DicomIndexEnd decodeIndexEnd(std::string_view body) {
  constexpr std::uint64_t most = std::uint64_t{1} << 31;
  WireReader wire(body);
  DicomIndexEnd end;
  for (std::int64_t* number : {&end.files, &end.dicomFiles, &end.unreadable})
    *number = static_cast<std::int64_t>(wire.number(0, most));
  end.firstReason = wire.text();
  wire.end();
  return end;
}

std::uint64_t bulkBytes(const DecodedVolume& announced) {
  return announced.header.voxels() * bytesOf(typeOf(announced.voxels));
}

std::uint64_t bulkBytes(const MeshCounts& announced) {
  return announced.points * sizeof(glm::dvec3) + announced.triangles * sizeof(Triangle);
}

std::uint64_t bulkBytes(const ImageSize& announced) {
  return static_cast<std::uint64_t>(announced.width) * static_cast<std::uint64_t>(announced.height) *
         sizeof(glm::vec3);
}

}  // namespace isolux::volume
