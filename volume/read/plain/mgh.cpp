#include "volume/read/plain/mgh.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/spacing_reliability.h"

namespace isolux::volume {

using base::throwInput;

namespace {

// Where the fields stand, bytes; four sizes lie side by side.
constexpr std::size_t kMghSizes = 4, kMghType = 20, kMghHasRas = 28, kMghDelta = 30, kMghDirections = 42,
                      kMghCentre = 78;

std::int32_t mghInteger(std::string_view head, std::size_t at) {
  return numberAt<std::int32_t>(head.data() + at, true);
}

glm::dvec3 mghVector(std::string_view head, std::size_t at) {
  glm::dvec3 vector;
  for (int i = 0; i < 3; ++i)
    vector[i] = static_cast<double>(
        numberAt<float>(head.data() + at + static_cast<std::size_t>(i) * sizeof(float), true));
  return vector;
}

// The codes of FreeSurfer's mri.h.
VoxelType mghType(std::int32_t code, const std::string& file) {
  constexpr std::pair<std::int32_t, VoxelType> codes[] = {{0, VoxelType::uint8},
                                                          {1, VoxelType::int32},
                                                          {3, VoxelType::float32},
                                                          {4, VoxelType::int16},
                                                          {10, VoxelType::uint16}};
  for (const auto& [known, type] : codes)
    if (known == code) return type;
  throwInput(file, "type",
             "the voxel type " + std::to_string(code) +
                 " is not supported; uchar (0), int (1), float (3), short (4) and ushort (10) are");
}

void readMghGeometry(std::string_view head, const std::string& file, ImageHeader& header) {
  glm::dvec3 spacing(1.0), centre(0.0);
  glm::dmat3 directions(glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0));  // RAS
  const bool stated = numberAt<std::int16_t>(head.data() + kMghHasRas, true) > 0;
  if (stated) {
    spacing = mghVector(head, kMghDelta);
    for (int axis = 0; axis < 3; ++axis)
      directions[axis] = mghVector(head, kMghDirections + static_cast<std::size_t>(axis) * 12);
    centre = mghVector(head, kMghCentre);
  } else {
    header.warnings.push_back(
        "goodRASFlag is 0: FreeSurfer's default, coronal slices, is taken; left and right are not certain");
    header.warnings.push_back("the spacing is missing; " + std::string(kSpacingAssumed));
  }
  const glm::dvec3 lps(-1.0, -1.0, 1.0);
  glm::dvec3 origin = centre * lps;
  for (int axis = 0; axis < 3; ++axis) {
    directions[axis] *= lps;
    origin -= directions[axis] * spacing[axis] *
              (0.5 * static_cast<double>(header.dims[static_cast<std::size_t>(axis)]));
  }
  header.worldFromVoxel = checkedGeometry(directions, spacing, origin, file, header.warnings);
  if (stated && usableDirections(directions)) header.axes = scene::WorldAxes::anatomical;
}

}  // namespace

bool looksLikeMgh(std::string_view head) {
  if (head.size() < kMghHeaderBytes || mghInteger(head, 0) != 1) return false;
  for (std::size_t i = 0; i < 4; ++i)
    if (const std::int32_t size = mghInteger(head, kMghSizes + 4 * i); size < 1 || size > 0xffffff)
      return false;
  const std::int32_t type = mghInteger(head, kMghType);
  return type >= 0 && type <= 255;
}

ImageHeader parseMghHeader(std::string_view head, bool packed, const std::string& file) {
  if (head.size() < kMghHeaderBytes)
    throwInput(file, "header",
               "truncated: an MGH header has 284 bytes, these are " + std::to_string(head.size()));
  if (mghInteger(head, 0) != 1)
    throwInput(file, "version", "is " + std::to_string(mghInteger(head, 0)) + ", not 1");
  ImageHeader header;
  header.format = "FreeSurfer MGH";
  header.type = mghType(mghInteger(head, kMghType), file);
  for (std::size_t axis = 0; axis < 3; ++axis) header.dims[axis] = mghInteger(head, kMghSizes + 4 * axis);
  header.timeSteps = mghInteger(head, kMghSizes + 12);
  checkDims(header, file, "width, height, depth, nframes");
  readMghGeometry(head, file, header);
  Payload& payload = header.payload;
  payload.endianness = Endianness::big;
  payload.moreMayFollow = true;
  if (packed) {
    payload.encoding = Encoding::zlib;
    payload.skipDecoded = kMghHeaderBytes;
  } else {
    payload.offset = kMghHeaderBytes;
  }
  return header;
}

}  // namespace isolux::volume
