// Planes through a volume as pictures: where each pixel's centre lies in the world, mm.
//
// Axial, coronal and sagittal planes stand across the world's z, y and x axis (DICOM/LPS), whatever the axes
// of the voxels are. Pictures of a patient are turned as they are read: axial ones with the front at the top
// and coronal ones with the head at the top, the patient's right on the left (radiological) or on the right
// (neurological); sagittal ones with the front on the left in both. Volumes that do not state where a patient
// lies are shown as the radiological convention has it.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/choices.h"
#include "scene/world_axes.h"
#include "volume/grid.h"

namespace isolux::volume {

enum class SliceDirection { axial, coronal, sagittal };

// The axis of the world that it stands across.
constexpr int axisOf(SliceDirection direction) {
  return 2 - static_cast<int>(direction);
}

// Unit vectors of a picture; right x down is where the viewer looks.
struct SliceFrame {
  glm::dvec3 right{1.0, 0.0, 0.0}, down{0.0, 1.0, 0.0};
  glm::dvec3 normal() const { return glm::cross(right, down); }
  bool operator==(const SliceFrame&) const = default;
};
SliceFrame sliceFrame(SliceDirection direction, scene::WorldAxes axes, scene::Convention convention);
// Of a plane with this normal (any length but 0, either side): the frame of the direction that it is nearest
// to, tilted.
SliceFrame sliceFrame(glm::dvec3 normal, scene::WorldAxes axes, scene::Convention convention);

struct SlicePlane {
  glm::dvec3 originMm{0.0};                                  // the centre of the top left pixel
  glm::dvec3 rightMm{1.0, 0.0, 0.0}, downMm{0.0, 1.0, 0.0};  // per pixel; orthogonal, equally long
  glm::ivec2 size{0};                                        // pixels
  glm::dvec3 at(glm::dvec2 pixel) const { return originMm + pixel.x * rightMm + pixel.y * downMm; }
  glm::dvec2 pixelOf(glm::dvec3 world) const;  // of its foot on the plane
  double pixelMm() const { return glm::length(rightMm); }
  SliceFrame frame() const { return {glm::normalize(rightMm), glm::normalize(downMm)}; }
  bool operator==(const SlicePlane&) const = default;
};

inline constexpr int kLargestSlice = 16384;  // pixels of an axis

// The plane through a point that shows the whole volume's outline, as seen along its normal. The first has
// pixels as large as the smaller spacing of the two voxel axes that lie most in the plane (larger where that
// were more than kLargestSlice), its outermost ones centred on the border; the second as large as fit.
SlicePlane nativeSlice(const GridGeometry& geometry, const SliceFrame& frame, glm::dvec3 pointMm);
SlicePlane fittedSlice(const GridGeometry& geometry, const SliceFrame& frame, glm::dvec3 pointMm,
                       glm::ivec2 size);

// How far along `normal` (a unit vector) one comes by a voxel, mm: where the voxel index that changes fastest
// changes by 1.
double voxelAlong(const GridGeometry& geometry, glm::dvec3 normal);

}  // namespace isolux::volume
