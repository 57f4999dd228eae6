// describe_volume PATH [COMPONENT [TIMESTEP]]: prints what readVolume() made of PATH as one JSON object, with
// the values at 27 voxels spread over the volume. Exit code of the Error, its text on stderr.
#include <cstdlib>
#include <iostream>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "volume/read/reader.h"

namespace {

nlohmann::json describe(const isolux::volume::Volume& volume) {
  const auto& grid = *volume.grid;
  const glm::ivec3 n = grid.dims();
  nlohmann::json matrix = nlohmann::json::array(), samples = nlohmann::json::array();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix.push_back(grid.geometry().worldFromVoxel[column][row]);
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const int i = (n.x - 1) * (2 * x + 1) / 6, j = (n.y - 1) * (2 * y + 1) / 6,
                  k = (n.z - 1) * (2 * z + 1) / 6;
        const double value = grid.value(i, j, k);
        samples.push_back({{"voxel", {i, j, k}}, {"value", value}});
      }
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  return {{"name", volume.name},
          {"format", volume.format},
          {"dims", {n.x, n.y, n.z}},
          {"type", isolux::volume::nameOf(volume.fileType)},
          {"stored_type", isolux::volume::nameOf(grid.storedType())},
          {"unit", volume.unit},
          {"components", volume.components},
          {"time_steps", volume.timeSteps},
          {"series", volume.seriesChoices},
          {"spacing_mm", {spacing.x, spacing.y, spacing.z}},
          {"world_from_voxel", matrix},
          {"slope", grid.slope()},
          {"intercept", grid.intercept()},
          {"range", {grid.minimum(), grid.maximum()}},
          {"missing", grid.missingCount()},
          {"samples", samples},
          {"warnings", volume.warnings}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    std::cerr << "usage: describe_volume PATH [COMPONENT [TIMESTEP]]\n";
    return 2;
  }
  isolux::volume::ReadOptions options;
  if (argc > 2) options.component = std::atoi(argv[2]);
  if (argc > 3) options.timeStep = std::atoi(argv[3]);
  isolux::base::Progress progress;
  try {
    const auto volume = isolux::volume::readVolume(argv[1], options, progress);
    std::cout << describe(volume).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    return 0;
  } catch (const isolux::base::Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.kind());
  }
}
