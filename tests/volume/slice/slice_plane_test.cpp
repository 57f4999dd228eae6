// Where the pixels of slices lie, and which side is which.
#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/analytic_fields.h"
#include "volume/slice/slice_plane.h"

namespace isolux::test {
namespace {

using scene::Convention;
using scene::WorldAxes;
using volume::SliceDirection;
using volume::SliceFrame;
using volume::SlicePlane;
const glm::dvec3 kLeft(1, 0, 0), kBack(0, 1, 0), kUp(0, 0, 1);

TEST(SlicePlane, RadiologistsSeeThePatientFromTheFeetAndFromTheFront) {
  const auto frame = [](SliceDirection direction, Convention convention) {
    return sliceFrame(direction, WorldAxes::anatomical, convention);
  };
  EXPECT_EQ(frame(SliceDirection::axial, Convention::radiological), (SliceFrame{kLeft, kBack}));
  EXPECT_EQ(frame(SliceDirection::axial, Convention::neurological), (SliceFrame{-kLeft, kBack}));
  EXPECT_EQ(frame(SliceDirection::coronal, Convention::radiological), (SliceFrame{kLeft, -kUp}));
  EXPECT_EQ(frame(SliceDirection::coronal, Convention::neurological), (SliceFrame{-kLeft, -kUp}));
  for (const Convention convention : {Convention::radiological, Convention::neurological})
    EXPECT_EQ(frame(SliceDirection::sagittal, convention), (SliceFrame{kBack, -kUp}));
}

TEST(SlicePlane, WithoutAPatientThereIsNoConvention) {
  for (const SliceDirection direction :
       {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal})
    EXPECT_EQ(sliceFrame(direction, WorldAxes::zUp, Convention::neurological),
              sliceFrame(direction, WorldAxes::anatomical, Convention::radiological));
}

TEST(SlicePlane, ANormalAlongAnAxisIsThatDirectionFromEitherSide) {
  for (const Convention convention : {Convention::radiological, Convention::neurological})
    for (const SliceDirection direction :
         {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal})
      for (const double side : {-1e-200, 3.0}) {
        glm::dvec3 normal(0.0);
        normal[axisOf(direction)] = side;
        const SliceFrame frame = volume::sliceFrame(normal, WorldAxes::anatomical, convention);
        const SliceFrame expected = sliceFrame(direction, WorldAxes::anatomical, convention);
        EXPECT_LT(glm::distance(frame.right, expected.right) + glm::distance(frame.down, expected.down),
                  1e-15);
      }
}

TEST(SlicePlane, TiltedFramesAreOrthogonalAndKeepTheirSides) {
  const SliceFrame frame =
      volume::sliceFrame(glm::dvec3(0.3, -0.2, -0.9), WorldAxes::anatomical, Convention::radiological);
  EXPECT_NEAR(glm::dot(frame.right, frame.down), 0.0, 1e-15);
  EXPECT_NEAR(glm::length(frame.right), 1.0, 1e-15);
  EXPECT_NEAR(glm::length(frame.down), 1.0, 1e-15);
  EXPECT_GT(glm::dot(frame.right, kLeft), 0.7);
  EXPECT_GT(glm::dot(frame.down, kBack), 0.7);
  EXPECT_NEAR(std::abs(glm::dot(frame.normal(), glm::normalize(glm::dvec3(0.3, -0.2, -0.9)))), 1.0, 1e-15);
}

TEST(SlicePlane, ShowsTheWholeVolumeAndPassesThroughThePoint) {
  const volume::GridGeometry geometry = obliqueLeftHandedGeometry(24);
  const SliceFrame frame =
      volume::sliceFrame(glm::dvec3(0.3, -0.2, 0.9), WorldAxes::anatomical, Convention::neurological);
  const glm::dvec3 point(geometry.worldFromVoxel * glm::dvec4(5, 9, 11, 1));
  for (const SlicePlane& plane :
       {nativeSlice(geometry, frame, point), fittedSlice(geometry, frame, point, {200, 150}),
        fittedSlice(geometry, frame, point, {1, 1})}) {
    EXPECT_NEAR(glm::dot(plane.originMm - point, frame.normal()), 0.0, 1e-10);
    EXPECT_LT(glm::distance(plane.at(plane.pixelOf(point)), point), 1e-10);
    EXPECT_NEAR(glm::length(plane.downMm), plane.pixelMm(), 1e-12);
    if (plane.size.x == 1) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 voxel = glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * 23.0;
      const glm::dvec2 pixel = plane.pixelOf(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0)));
      EXPECT_GE(std::min(pixel.x, pixel.y), -0.5);
      EXPECT_LE(pixel.x, plane.size.x - 0.5);
      EXPECT_LE(pixel.y, plane.size.y - 0.5);
    }
  }
}

TEST(SlicePlane, AStepOfAVoxelChangesTheFastestIndexByOne) {
  const auto geometry = volume::GridGeometry::make({9, 9, 9}, {0.5, 0.7, 2.5});
  EXPECT_NEAR(voxelAlong(geometry, {0, 0, 1}), 2.5, 1e-12);
  EXPECT_NEAR(voxelAlong(geometry, {-1, 0, 0}), 0.5, 1e-12);
  EXPECT_NEAR(voxelAlong(geometry, glm::normalize(glm::dvec3(0, 1, 1))), 0.7 * std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace isolux::test
