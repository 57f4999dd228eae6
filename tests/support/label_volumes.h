// Label maps for tests: balls with a label each, as grids, and loaded from a file as a scan is.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "volume/write/writer.h"

namespace isolux::test {

struct LabelBall {
  glm::dvec3 middle{0.0};  // voxels
  double radius = 1.0;     // voxels
};

// uint8: voxels within the i-th ball have label i + 1, those within several the first; others 0.
inline volume::Grid gridOfLabels(glm::ivec3 dims, const std::vector<LabelBall>& balls) {
  std::vector<std::uint8_t> voxels;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        std::uint8_t label = 0;
        for (std::size_t i = balls.size(); i-- > 0;)
          if (glm::length(glm::dvec3(x, y, z) - balls[i].middle) < balls[i].radius)
            label = static_cast<std::uint8_t>(i + 1);
        voxels.push_back(label);
      }
  return volume::Grid(unitGeometry(dims), std::move(voxels));
}

// Three balls: 1 and 2 touch, 3 is apart.
inline volume::Grid threeLabels() {
  return gridOfLabels(glm::ivec3(48, 40, 40),
                      {{{14.0, 18.0, 18.0}, 9.5}, {{29.0, 18.0, 18.0}, 7.5}, {{38.0, 31.0, 30.0}, 5.5}});
}

// Writes the grid and loads it with these `source.labels` and `source.smoothing`.
inline std::shared_ptr<const volume::PreparedVolume> loadedLabels(const volume::Grid& grid,
                                                                  const std::string& labels = "",
                                                                  double smoothing = 1.0) {
  base::Progress progress;
  scene::Source source;
  source.path = (temporaryFolder() / "labels.mha").string();
  volume::writeVolume(grid, source.path);
  source.kind = scene::DataKind::labels;
  source.labels = labels;
  source.smoothing = smoothing;
  return volume::loadVolume(source, progress);
}

}  // namespace isolux::test
