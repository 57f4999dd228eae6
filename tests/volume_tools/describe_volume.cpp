// describe_volume PATH [COMPONENT [TIMESTEP [all]]]: prints what readVolume() made of PATH as one JSON
// object, with the values at 27 voxels spread over the volume, or at all of them, and a sum over all. Of what
// can be read in parts, parts are read, too, and compared ("parts_differ"). Exit code of the Error, its text
// on stderr.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "volume/labels/label_table.h"
#include "volume/read/reader.h"
#include "volume/read/volume_file.h"

namespace {

// The sum of all values, each times (x + 2 y + 3 z) mod 11: tells voxels that lie elsewhere.
double placedSum(const isolux::volume::Grid& grid) {
  double sum = 0.0;
  const glm::ivec3 n = grid.dims();
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x)
        if (const double value = grid.value(x, y, z); !std::isnan(value))
          sum += value * static_cast<double>((x + 2 * y + 3 * z) % 11);
  return sum;
}

// Voxels of 40 boxes that are not those of the whole.
template <class T>
int differences(const isolux::volume::ChunkedVolume& parts, isolux::volume::VolumePart part,
                const isolux::volume::Grid& whole) {
  std::uint32_t state = 1;
  const auto below = [&](int n) {
    state = state * 1664525u + 1013904223u;
    return static_cast<int>((state >> 8) % static_cast<std::uint32_t>(n));
  };
  // float32 in parts, where the whole may have an intercept that keeps more.
  const double tolerance = 1e-6 * (whole.maximum() - whole.minimum());
  const auto same = [&](double a, double b) {
    return std::isnan(a) ? std::isnan(b) : std::abs(a - b) <= tolerance;
  };
  int different = 0;
  const glm::ivec3 n = whole.dims();
  for (int box = 0; box < 40; ++box) {
    const glm::ivec3 low(below(n.x), below(n.y), below(n.z));
    const glm::ivec3 size(1 + below(n.x - low.x), 1 + below(n.y - low.y), 1 + below(n.z - low.z));
    std::vector<T> voxels(static_cast<std::size_t>(size.x * size.y * size.z));
    parts.read(part, 0, low, size, std::as_writable_bytes(std::span(voxels)));
    std::size_t i = 0;
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x, ++i)
          if (!same(whole.value(low.x + x, low.y + y, low.z + z),
                    parts.facts().slope * static_cast<double>(voxels[i]) + parts.facts().intercept))
            ++different;
  }
  return different;
}

int differences(const isolux::volume::ChunkedVolume& parts, isolux::volume::VolumePart part,
                const isolux::volume::Grid& whole) {
  using isolux::volume::VoxelType;
  switch (parts.facts().storedType) {
    case VoxelType::int8:
      return differences<std::int8_t>(parts, part, whole);
    case VoxelType::uint8:
      return differences<std::uint8_t>(parts, part, whole);
    case VoxelType::int16:
      return differences<std::int16_t>(parts, part, whole);
    case VoxelType::uint16:
      return differences<std::uint16_t>(parts, part, whole);
    default:
      return differences<float>(parts, part, whole);
  }
}

nlohmann::json labelsOf(const isolux::volume::LabelTable* table) {
  if (!table) return nullptr;
  nlohmann::json list = nlohmann::json::array();
  for (const auto& label : table->labels) {
    const glm::vec3 color = isolux::volume::labelColor(table, label.value);
    list.push_back({{"label", label.value}, {"name", label.name}, {"color", {color.x, color.y, color.z}}});
  }
  return {{"reason", table->reason}, {"source", table->source}, {"list", list}};
}

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
          {"orientation_stated", volume.axes == isolux::scene::WorldAxes::anatomical},
          {"components", volume.components},
          {"time_steps", volume.timeSteps},
          {"series", volume.seriesChoices},
          {"spacing_mm", {spacing.x, spacing.y, spacing.z}},
          {"world_from_voxel", matrix},
          {"slope", grid.slope()},
          {"intercept", grid.intercept()},
          {"range", {grid.minimum(), grid.maximum()}},
          {"placed_sum", placedSum(grid)},
          {"missing", grid.missingCount()},
          {"isovalue", volume.isovalue ? nlohmann::json(*volume.isovalue) : nlohmann::json()},
          {"labels", labelsOf(volume.labelTable.get())},
          {"samples", samples},
          {"warnings", volume.warnings}};
}

}  // namespace

int main(int argc, char** argv) {
  const bool all = argc == 5 && std::string_view(argv[4]) == "all";
  if (argc < 2 || argc > 5 || (argc == 5 && !all)) {
    std::cerr << "usage: describe_volume PATH [COMPONENT [TIMESTEP [all]]]\n";
    return 2;
  }
  isolux::volume::ReadOptions options;
  if (argc > 2) options.component = std::atoi(argv[2]);
  if (argc > 3) options.timeStep = std::atoi(argv[3]);
  isolux::base::Progress progress;
  try {
    const auto file = isolux::volume::openVolume(argv[1], options, progress);
    const auto volume = file.readWhole(options, progress);
    nlohmann::json json = describe(volume);
    if (all)
      for (std::size_t i = 0; i < volume.grid->extent().count(); ++i)
        json["values"].push_back(volume.grid->value(volume.grid->extent().at(i)));
    if (const auto& parts = file.parts) {
      json["parts_differ"] = differences(*parts, {options.timeStep, options.component}, *volume.grid);
      json["levels"] = parts->facts().levels.size();
    }
    std::cout << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    return 0;
  } catch (const isolux::base::Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.kind());
  }
}
