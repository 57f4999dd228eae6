// Noise of derivatives near the border of a volume, judged by fields of noise.
#include "volume/field/noise_gain.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/noise_at_border.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {
namespace {

Grid whiteNoise(glm::ivec3 dims) {
  std::vector<float> values(static_cast<std::size_t>(dims.x * dims.y * dims.z));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(base::normalNoise(5, i));
  return Grid(GridGeometry::make(dims, glm::dvec3(1.0), glm::dvec3(0.0)), std::move(values));
}

// Root mean square of second derivatives along a border, `voxels` from it.
double rmsAlongBorder(const Grid& grid, const ScaledField& field, double voxels) {
  double squares = 0.0;
  int count = 0;
  for (double y = 10.0; y < grid.dims().y - 10.0; y += 0.7)
    for (double z = 10.0; z < grid.dims().z - 10.0; z += 0.7, count += 2) {
      const glm::dmat3 h = sampleScaled(field, grid, {voxels, y, z}).hessian;
      squares += h[1][1] * h[1][1] + h[2][2] * h[2][2];
    }
  return std::sqrt(squares / count);
}

TEST(NoiseGain, NearTheBorderIsThatOfReflectedSamples) {
  const Grid grid = whiteNoise({40, 90, 90});
  base::Progress progress;
  for (const double scale : {1.0, 1.5, 2.0}) {
    const ScaledField field = scaledField(grid, scene::Field::cubic_interpolating, scale, progress);
    const double within = rmsAlongBorder(grid, field, 20.0);
    for (const double voxels : {0.0, 0.4 * scale, 0.8 * scale, 1.6 * scale, 3.0 * scale}) {
      const double expected = test::noiseAtBorder({voxels, 40.0, 40.0}, grid.dims(), glm::dvec3(scale));
      EXPECT_NEAR(rmsAlongBorder(grid, field, voxels) / within, expected, 0.15 * expected)
          << scale << ' ' << voxels;
    }
    EXPECT_NEAR(test::noiseAtBorder({20.0, 40.0, 40.0}, grid.dims(), glm::dvec3(scale)), 1.0, 1e-3);
  }
}

}  // namespace
}  // namespace isolux::volume
