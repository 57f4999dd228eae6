// A head that is scanned again in slices of 5 mm keeps its measures within what is stated of them.
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/volumes.h"
#include "volume/measure/surface_measure.h"

namespace isolux::test {
namespace {

// Each slice the mean of `thick` ones, at their middle: a scanner's slice profile.
volume::Grid inThickSlices(const volume::Grid& fine, int thick) {
  volume::GridGeometry geometry = fine.geometry();
  geometry.dims.z /= thick;
  geometry.worldFromVoxel[3] += geometry.worldFromVoxel[2] * (0.5 * (thick - 1));
  geometry.worldFromVoxel[2] *= static_cast<double>(thick);
  return gridOfVoxels(geometry, [&](glm::dvec3 p) {
    double sum = 0.0;
    for (int i = 0; i < thick; ++i)
      sum += fine.value(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z) * thick + i);
    return sum / thick;
  });
}

volume::SurfaceMeasure measured(const volume::PreparedVolume& volume, double isovalue) {
  base::Progress progress;
  return measureSurface(volume.grid(), *volume.blocks, {.isovalue = isovalue}, progress);
}

TEST(ThickSlicesTest, AHeadKeepsItsAreaAndVolume) {
  const auto fine = phantom("head", 128);
  const double spacing = glm::length(glm::dvec3(fine->grid().geometry().worldFromVoxel[2]));
  const int thick = static_cast<int>(std::lround(5.0 / spacing));
  const auto coarse = prepared(inThickSlices(fine->grid(), thick));
  for (const double isovalue : {0.3, 0.7}) {
    const auto a = measured(*fine, isovalue), b = measured(*coarse, isovalue);
    EXPECT_NEAR(b.areaMm2.value, a.areaMm2.value, a.areaMm2.error + b.areaMm2.error);
    EXPECT_NEAR(b.volumeMm3.value, a.volumeMm3.value, a.volumeMm3.error + b.volumeMm3.error);
  }
}

}  // namespace
}  // namespace isolux::test
