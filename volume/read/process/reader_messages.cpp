#include "volume/read/process/reader_messages.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "volume/read/process/wire.h"

namespace isolux::volume {

namespace {

constexpr std::size_t mostWarnings = 10000, mostSeries = 1000000, mostSkippedFiles = 1000, mostLabels = 65536;
constexpr std::uint64_t kAnyNumber = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kMostSteps = std::uint64_t{1} << 31;
constexpr auto kLastType = static_cast<std::uint64_t>(VoxelType::float64);
constexpr std::uint64_t mostPoints = std::uint64_t{1} << 31, mostTriangles = std::uint64_t{1} << 30;

VoxelType typeOf(const FileVoxels& voxels) {
  return static_cast<VoxelType>(voxels.index());
}

// What each message holds, for WireWriter and WireReader.

constexpr auto passPatient = [](auto& wire, auto& patient) {
  for (auto* text : {&patient.name, &patient.id, &patient.birthDate}) wire.pass(*text);
};

constexpr auto passRequest = [](auto& wire, auto& request) {
  wire.pass(request.task, 1, static_cast<std::uint64_t>(Task::chunks));
  wire.pass(request.path);
  wire.pass(request.options.series);
  wire.pass(request.options.component, 0, kAnyNumber);
  wire.pass(request.options.timeStep, 0, kAnyNumber);
  wire.pass(request.options.budgetBytes, 0, kAnyNumber);
  wire.pass(request.skip, mostSkippedFiles);
  for (int axis = 0; axis < 3; ++axis) wire.pass(request.contourDims[axis], 0, 1u << 24);
  wire.pass(request.parent, 0, kAnyNumber);
};

// The empty reason of a table is that of no table.
constexpr auto passLabels = [](auto& wire, auto& table) {
  wire.pass(table.reason);
  wire.pass(table.source);
  wire.passEach(table.labels, 0, mostLabels, [&wire](auto& label) {
    wire.pass(label.value, 0, kAnyNumber);
    wire.pass(label.name);
    wire.pass(label.layer, 0, mostLabels);
    double hasColor = label.color ? 1.0 : 0.0;
    wire.pass(hasColor);
    glm::dvec3 color(label.color.value_or(glm::vec3(0.0f)));
    for (int axis = 0; axis < 3; ++axis) wire.passFinite(color[axis]);
    if constexpr (std::is_same_v<decltype(wire), WireReader&>)
      if (hasColor != 0.0) label.color = glm::vec3(color);
  });
};

constexpr auto passVolume = [](auto& wire, auto& volume) {
  auto& header = volume.header;
  wire.pass(header.format);
  wire.pass(header.type, 0, kLastType);
  for (auto& axis : header.dims) wire.pass(axis, 1, 65535);
  wire.pass(header.components, 1, kMostSteps);
  wire.pass(header.timeSteps, 1, kMostSteps);
  wire.passFinite(header.worldFromVoxel);
  wire.pass(header.axes, 0, static_cast<std::uint64_t>(scene::WorldAxes::anatomical));
  wire.pass(header.slope);  // 0 and NaN have a meaning
  wire.pass(header.intercept);
  wire.pass(header.unit);
  wire.pass(header.warnings, mostWarnings);
  double isovalue = header.isovalue.value_or(std::numeric_limits<double>::quiet_NaN());
  wire.pass(isovalue);
  LabelTable labels = header.labels ? *header.labels : LabelTable{};
  passLabels(wire, labels);
  if constexpr (std::is_same_v<decltype(wire), WireReader&>) {
    if (std::isfinite(isovalue)) header.isovalue = isovalue;
    if (!labels.reason.empty()) header.labels = std::make_shared<const LabelTable>(std::move(labels));
  }
  wire.pass(volume.name);
  wire.pass(volume.seriesChoices, mostSeries);
  passPatient(wire, volume.patient);
  VoxelType type = typeOf(volume.voxels);
  wire.pass(type, 0, kLastType);
  if constexpr (std::is_same_v<decltype(wire), WireReader&>)
    withType(type, [&](auto zero) { volume.voxels = std::vector<decltype(zero)>(); });
};
constexpr auto passMesh = [](auto& wire, auto& mesh) {
  wire.pass(mesh.points, 0, mostPoints);
  wire.pass(mesh.triangles, 0, mostTriangles);
};
constexpr auto passImage = [](auto& wire, auto& size) {
  for (auto* side : {&size.width, &size.height}) wire.pass(*side, 1, kMostImagePixels);
};

constexpr auto passSeries = [](auto& wire, auto& series) {
  passPatient(wire, series.patient);
  for (auto* text : {&series.study, &series.studyDescription, &series.studyDate, &series.series,
                     &series.description, &series.date, &series.modality, &series.kernel, &series.number,
                     &series.folder, &series.problem, &series.middleFile})
    wire.pass(*text);
  for (auto* number : {&series.columns, &series.rows, &series.slices, &series.timeSteps})
    wire.pass(*number, 0, kMostSteps);
  for (int axis = 0; axis < 3; ++axis) wire.passFinite(series.spacingMm[axis]);
  wire.pass(series.warnings, mostWarnings);
  wire.pass(series.middleFrame, 0, 65535);
};

constexpr auto passIndexEnd = [](auto& wire, auto& end) {
  for (auto* number : {&end.files, &end.dicomFiles, &end.unreadable}) wire.pass(*number, 0, kMostSteps);
  wire.pass(end.firstReason);
};

}  // namespace

std::string encode(const Request& request) {
  return messageBytes(request, passRequest);
}

Request decodeRequest(std::string_view body) {
  return messageOf<Request>(body, passRequest);
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
  return messageBytes(volume, passVolume);
}

DecodedVolume decodeVolume(std::string_view body) {
  auto volume = messageOf<DecodedVolume>(body, passVolume);
  if (!usableAffine(volume.header.worldFromVoxel)) throwBadAnswer("spacing or orientation is degenerate");
  checkDims(volume.header, "", "answer of the reader");
  return volume;
}

std::string encode(const TriangleMesh& mesh) {
  return messageBytes(MeshCounts{mesh.points.size(), mesh.triangles.size()}, passMesh);
}

MeshCounts decodeMesh(std::string_view body) {
  return messageOf<MeshCounts>(body, passMesh);
}

std::string encode(const DecodedImage& image) {
  return messageBytes(ImageSize{image.width, image.height}, passImage);
}

ImageSize decodeImage(std::string_view body) {
  const auto size = messageOf<ImageSize>(body, passImage);
  if (std::int64_t{size.width} * size.height > kMostImagePixels)
    throwBadAnswer("an image is larger than one may be");
  return size;
}

std::string encode(const DicomSeries& series) {
  return messageBytes(series, passSeries);
}

DicomSeries decodeSeries(std::string_view body) {
  return messageOf<DicomSeries>(body, passSeries);
}

std::string encode(const DicomIndexEnd& end) {
  return messageBytes(end, passIndexEnd);
}

DicomIndexEnd decodeIndexEnd(std::string_view body) {
  return messageOf<DicomIndexEnd>(body, passIndexEnd);
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
