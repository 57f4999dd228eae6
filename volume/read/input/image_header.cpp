#include "volume/read/input/image_header.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

using base::throwInput;

std::optional<VoxelType> typeNamed(std::span<const TypeName> names, std::string_view name) {
  for (const TypeName& entry : names)
    if (sameIgnoringCase(entry.name, name)) return entry.type;
  return std::nullopt;
}

std::uint64_t ImageHeader::voxels() const {
  return static_cast<std::uint64_t>(dims[0]) * static_cast<std::uint64_t>(dims[1]) *
         static_cast<std::uint64_t>(dims[2]);
}

std::uint64_t ImageHeader::elements() const {
  return voxels() * static_cast<std::uint64_t>(components) * static_cast<std::uint64_t>(slowComponents) *
         static_cast<std::uint64_t>(timeSteps);
}

void checkDims(const ImageHeader& header, const std::string& file, const std::string& place) {
  for (std::int64_t n : header.dims) {
    if (n < 1) throwInput(file, place, "an axis has " + std::to_string(n) + " voxels; at least 1 is needed");
    if (n > 65535)
      throwInput(file, place, "an axis has " + std::to_string(n) + " voxels; at most 65535 are read");
  }
  std::uint64_t bytes = header.voxels();
  for (std::int64_t n : {header.components, header.slowComponents, header.timeSteps,
                         static_cast<std::int64_t>(bytesOf(header.type))}) {
    if (n < 1 || __builtin_mul_overflow(bytes, static_cast<std::uint64_t>(n), &bytes) ||
        bytes > (std::uint64_t{1} << 62) || n > 1000000)
      throwInput(file, place, "components or time steps are absurd");
  }
}

glm::dmat4 checkedGeometry(glm::dmat3 directions, glm::dvec3 spacingMm, glm::dvec3 originMm,
                           const std::string& file, std::vector<std::string>& warnings) {
  for (int axis = 0; axis < 3; ++axis) {
    double& spacing = spacingMm[axis];
    const std::string name(1, "xyz"[axis]);
    if (!std::isfinite(spacing) || spacing == 0.0) {
      warnings.push_back("spacing along " + name + " is " + base::shortText(spacing) + "; " +
                         std::string(kSpacingAssumed));
      spacing = 1.0;
    } else if (std::abs(spacing) < 1e-9 || std::abs(spacing) > 1e9) {
      throwInput(file, "spacing",
                 "spacing along " + name + " is " + base::shortText(spacing) +
                     " mm; sizes from 1e-9 to 1e9 mm are read");
    } else if (spacing < 0.0) {
      warnings.push_back("spacing along " + name + " is negative; the axis runs backwards");
    }
  }
  if (!usableDirections(directions)) {
    warnings.push_back("the direction matrix is singular or not finite; the identity is used instead");
    directions = glm::dmat3(1.0);
  }
  if (!std::isfinite(originMm.x) || !std::isfinite(originMm.y) || !std::isfinite(originMm.z)) {
    warnings.push_back("the origin is not finite; 0 assumed");
    originMm = glm::dvec3(0.0);
  }
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(originMm[axis]) > 1e12) throwInput(file, "origin", "is more than 1e12 mm away");
  return GridGeometry::make(glm::ivec3(1), spacingMm, originMm, directions).worldFromVoxel;
}

bool usableDirections(glm::dmat3 directions) {
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(directions[axis]);
    if (!(length > 1e-12) || !(length < 1e12)) return false;
    directions[axis] /= length;
  }
  return std::abs(glm::determinant(directions)) > 1e-3;
}

bool usableAffine(const glm::dmat4& worldFromVoxel) {
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(glm::dvec3(worldFromVoxel[axis]));
    if (!(length >= 1e-9) || !(length <= 1e9)) return false;
    if (!(std::abs(worldFromVoxel[3][axis]) <= 1e12)) return false;
  }
  return usableDirections(glm::dmat3(worldFromVoxel));
}

}  // namespace isolux::volume
