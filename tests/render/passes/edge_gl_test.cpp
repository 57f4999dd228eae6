// Edges in pictures: against the double precision walk at the hits of the picture, on both executors.
#include <cmath>
#include <limits>

#include "render/volume/gpu_volume.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/analytic_fields.h"
#include "volume/edge/surface_edges.h"

namespace isolux::test {
namespace {

using render::Aov;
using VolumePointer = std::shared_ptr<const volume::PreparedVolume>;

constexpr glm::ivec2 kEdgeSize{64, 56};

// A ball of soft boundary, 10 % noise, in a box of bright voxels at one side.
VolumePointer softBall(const volume::GridGeometry& geometry, bool gap) {
  const glm::dvec3 middle = 0.5 * glm::dvec3(geometry.dims - 1);
  const double radius = 0.35 * static_cast<double>(geometry.dims.x);
  const volume::Grid plain = gridOfVoxels(geometry, [&](glm::dvec3 p) {
    if (gap && std::abs(p.x - 14.0) < 1.5) return std::numeric_limits<double>::quiet_NaN();
    return 100.0 * std::erfc((glm::length(p - middle) - radius) / 2.0) + (p.y > 24.0 ? 60.0 : 0.0);
  });
  return prepared(withNoise(plain, 4.0, glm::dvec3(0.0), 5));
}

struct Apart {
  int count = 0, edges = 0, far = 0, otherwise = 0;  // beyond 0.02 voxels; an edge in one of both only
  double strength = 0.0;                             // relative
};

class EdgeGlTest : public ExecutorsGlTest {
 protected:
  Apart against(const VolumePointer& volume, scene::Scene scene) {
    images(volume, scene, kEdgeSize);
    const render::AovImage hit = renderer_->readAov(Aov::hit), voxel = renderer_->readAov(Aov::voxel),
                           offset = renderer_->readAov(Aov::edge_offset),
                           strength = renderer_->readAov(Aov::edge_strength);
    base::Progress progress;
    const volume::SurfaceEdges edges(volume, scene, progress);
    const double spacing =
        std::cbrt(std::abs(glm::determinant(glm::dmat3(volume->grid().geometry().worldFromVoxel))));
    Apart apart;
    for (std::size_t i = 0; i < hit.values.size(); ++i) {
      if (hit.values[i] != 1.0f) {
        EXPECT_TRUE(std::isnan(offset.values[i]));
        continue;
      }
      ++apart.count;
      const volume::Edge edge = edges.finder().at(at(voxel, i));
      if (edge.strength > 0.0)
        apart.strength = std::max(apart.strength, std::abs(strength.values[i] / edge.strength - 1.0));
      if (edge.offsetMm.has_value() == std::isnan(offset.values[i]))
        ++apart.otherwise;
      else if (edge.offsetMm && ++apart.edges)
        apart.far += std::abs(offset.values[i] - *edge.offsetMm) > 0.02 * spacing;
    }
    return apart;
  }
};

TEST_P(EdgeGlTest, AgreeWithDoublePrecision) {
  for (const bool gap : {false, true})
    for (const auto& geometry : {isotropicGeometry(32), obliqueLeftHandedGeometry(32)}) {
      const VolumePointer volume = softBall(geometry, gap);
      for (const auto field :
           {scene::Field::trilinear, scene::Field::cubic, scene::Field::cubic_interpolating})
        for (const double scale : {0.0, 1.2}) {
          if (field == scene::Field::trilinear && scale > 0.0) continue;
          scene::Scene scene;
          scene.surfaces.front().value = 70.0;
          scene.derivatives = {field, scene::Fetch::exact, 4.0, scale, 0.0};
          scene.edge.search = 4.0;
          const Apart apart = against(volume, scene);
          SCOPED_TRACE(::testing::Message()
                       << "gap " << gap << ", field " << static_cast<int>(field) << ", scale " << scale
                       << ": " << apart.count << " points, " << apart.edges << " edges");
          EXPECT_GT(apart.edges, 200);
          EXPECT_LT(apart.strength, 1e-3);
          // Where a peak is hardly one, rounding decides.
          EXPECT_LE(apart.far, apart.edges / 200);
          EXPECT_LE(apart.otherwise, apart.count / 200);
        }
    }
}

ISOLUX_ON_BOTH_EXECUTORS(EdgeGlTest);

}  // namespace
}  // namespace isolux::test
