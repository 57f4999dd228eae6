#include "volume/slice/slice_plane.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace isolux::volume {

namespace {

// What the volume's domain covers in the directions of a picture, mm.
using Outline = Bounds<glm::dvec2>;

Outline outlineOf(const GridGeometry& geometry, const SliceFrame& frame) {
  Outline outline;
  for (const glm::dvec3& corner : geometry.corners())
    outline.add({glm::dot(corner, frame.right), glm::dot(corner, frame.down)});
  return outline;
}

double nativePixel(const GridGeometry& geometry, const SliceFrame& frame) {
  const glm::dmat3 directions = geometry.directions();
  const glm::dvec3 spacing = geometry.spacingMm(), normal = frame.normal();
  int across = 2;
  for (int axis = 1; axis >= 0; --axis)
    if (std::abs(glm::dot(directions[axis], normal)) > std::abs(glm::dot(directions[across], normal)) + 1e-12)
      across = axis;
  return std::min(spacing[(across + 1) % 3], spacing[(across + 2) % 3]);
}

SlicePlane planeAbout(const SliceFrame& frame, glm::dvec3 pointMm, const Outline& outline, double pixelMm,
                      glm::ivec2 size) {
  const glm::dvec2 first =
      0.5 * (outline.low + outline.high) - 0.5 * pixelMm * (glm::dvec2(size) - glm::dvec2(1.0));
  SlicePlane plane;
  plane.rightMm = pixelMm * frame.right;
  plane.downMm = pixelMm * frame.down;
  plane.size = size;
  plane.originMm = pointMm + (first.x - glm::dot(pointMm, frame.right)) * frame.right +
                   (first.y - glm::dot(pointMm, frame.down)) * frame.down;
  return plane;
}

}  // namespace

SliceFrame sliceFrame(SliceDirection direction, scene::WorldAxes axes, scene::Convention convention) {
  if (direction == SliceDirection::sagittal) return {{0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};
  const bool turned = axes == scene::WorldAxes::anatomical && convention == scene::Convention::neurological;
  const glm::dvec3 right(turned ? -1.0 : 1.0, 0.0, 0.0);
  if (direction == SliceDirection::axial) return {right, {0.0, 1.0, 0.0}};
  return {right, {0.0, 0.0, -1.0}};
}

SliceFrame sliceFrame(glm::dvec3 normal, scene::WorldAxes axes, scene::Convention convention) {
  glm::dvec3 n =
      glm::normalize(normal / std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}));
  auto nearest = SliceDirection::axial;
  for (const SliceDirection other : {SliceDirection::coronal, SliceDirection::sagittal})
    if (std::abs(n[axisOf(other)]) > std::abs(n[axisOf(nearest)]) + 1e-12) nearest = other;
  const SliceFrame straight = sliceFrame(nearest, axes, convention);
  if (glm::dot(n, straight.normal()) < 0.0) n = -n;
  const glm::dvec3 down = glm::normalize(straight.down - n * glm::dot(n, straight.down));
  return {glm::cross(down, n), down};
}

glm::dvec2 SlicePlane::pixelOf(glm::dvec3 world) const {
  const glm::dvec3 from = world - originMm;
  return {glm::dot(from, rightMm) / glm::dot(rightMm, rightMm),
          glm::dot(from, downMm) / glm::dot(downMm, downMm)};
}

SlicePlane nativeSlice(const GridGeometry& geometry, const SliceFrame& frame, glm::dvec3 pointMm) {
  const Outline outline = outlineOf(geometry, frame);
  const glm::dvec2 extent = outline.size();
  const double pixel =
      std::max(nativePixel(geometry, frame), std::max(extent.x, extent.y) / (kLargestSlice - 1));
  const glm::ivec2 size = glm::ivec2(glm::ceil(extent / pixel - 1e-6)) + 1;
  return planeAbout(frame, pointMm, outline, pixel, glm::min(size, glm::ivec2(kLargestSlice)));
}

SlicePlane fittedSlice(const GridGeometry& geometry, const SliceFrame& frame, glm::dvec3 pointMm,
                       glm::ivec2 size) {
  const Outline outline = outlineOf(geometry, frame);
  const glm::dvec2 pixels = outline.size() / glm::max(glm::dvec2(size) - 1.0, glm::dvec2(0.5));
  const double pixel = std::max(pixels.x, pixels.y);
  return planeAbout(frame, pointMm, outline, pixel > 0.0 ? pixel : nativePixel(geometry, frame), size);
}

double voxelAlong(const GridGeometry& geometry, glm::dvec3 normal) {
  const glm::dvec3 voxels = glm::abs(glm::dmat3(geometry.voxelFromWorld()) * normal);
  return 1.0 / std::max({voxels.x, voxels.y, voxels.z});
}

}  // namespace isolux::volume
