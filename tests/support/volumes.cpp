#include "tests/support/volumes.h"

#include <cmath>

#include "base/random.h"

#include "volume/phantom/phantom.h"

namespace isolux::test {

namespace {

volume::Grid made(const volume::PhantomRequest& request) {
  base::Progress progress;
  return volume::makePhantom(request, progress);
}

}  // namespace

volume::GridGeometry unitGeometry(glm::ivec3 dims) {
  return volume::GridGeometry::make(dims, glm::dvec3(1));
}

volume::Grid phantomGrid(const std::string& name, int size, double noise) {
  volume::PhantomRequest request;
  request.name = name;
  request.size = size;
  request.noise = noise;
  return made(request);
}

volume::Grid phantomGrid(const std::string& name, const volume::GridGeometry& geometry) {
  volume::PhantomRequest request;
  request.name = name;
  request.geometry = geometry;
  return made(request);
}

volume::Grid phantomGrid(const std::string& name, glm::ivec3 dims) {
  return phantomGrid(name, unitGeometry(dims));
}

namespace {

std::shared_ptr<const volume::PreparedVolume> preparedWith(volume::Grid grid, std::optional<double> noise) {
  base::Progress progress;
  volume::Volume volume;
  volume.grid = std::make_shared<const volume::Grid>(std::move(grid));
  volume.name = "test";
  volume.noise = noise;
  return volume::prepareVolume(std::move(volume), progress);
}

// As volume::readVolume() has it of phantoms.
std::optional<double> noiseOfPhantom(const std::string& name) {
  return name == "noise" ? std::nullopt : std::optional(0.0);
}

}  // namespace

std::shared_ptr<const volume::PreparedVolume> prepared(volume::Grid grid) {
  return preparedWith(std::move(grid), std::nullopt);
}

std::shared_ptr<const volume::PreparedVolume> phantom(const std::string& name, int size) {
  return preparedWith(phantomGrid(name, size), noiseOfPhantom(name));
}

std::shared_ptr<const volume::PreparedVolume> phantom(const std::string& name,
                                                      const volume::GridGeometry& geometry) {
  return preparedWith(phantomGrid(name, geometry), noiseOfPhantom(name));
}

std::vector<float> blurredNoise(glm::ivec3 dims, glm::dvec3 blur, std::uint64_t seed) {
  const auto count =
      static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z);
  std::vector<float> values(count), blurred(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(base::normalNoise(seed, i));
  std::size_t stride = 1;
  for (int axis = 0; axis < 3; stride *= static_cast<std::size_t>(dims[axis++])) {
    if (!(blur[axis] > 0.0)) continue;
    const int reach = static_cast<int>(std::ceil(5.0 * blur[axis])), length = dims[axis];
    std::vector<double> weights;
    double squares = 0.0;
    for (int k = -reach; k <= reach; ++k) {
      weights.push_back(std::exp(-0.5 * k * k / (blur[axis] * blur[axis])));
      squares += weights.back() * weights.back();
    }
    for (std::size_t i = 0; i < count; ++i) {
      const int at = static_cast<int>(i / stride % static_cast<std::size_t>(length));
      const std::size_t first = i - static_cast<std::size_t>(at) * stride;
      double sum = 0.0;
      for (int k = -reach; k <= reach; ++k) {
        const int from = ((at + k) % length + length) % length;
        sum += weights[static_cast<std::size_t>(k + reach)] *
               values[first + static_cast<std::size_t>(from) * stride];
      }
      blurred[i] = static_cast<float>(sum / std::sqrt(squares));
    }
    values.swap(blurred);
  }
  return values;
}

volume::Grid withNoise(const volume::Grid& grid, double deviation, glm::dvec3 blur, std::uint64_t seed) {
  const glm::ivec3 dims = grid.dims();
  std::vector<float> values = blurredNoise(dims, blur, seed);
  std::size_t i = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++i)
        values[i] = static_cast<float>(grid.value(x, y, z) + deviation * values[i]);
  return volume::Grid(grid.geometry(), std::move(values));
}

volume::Grid roundedWithNoise(const volume::Grid& grid, double deviation, glm::dvec3 blur, std::uint64_t seed,
                              double air) {
  const volume::Grid noisy = withNoise(grid, deviation, blur, seed);
  const glm::ivec3 dims = grid.dims();
  std::vector<std::int16_t> values;
  values.reserve(grid.geometry().voxelCount());
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        values.push_back(static_cast<std::int16_t>(
            grid.value(x, y, z) <= air ? std::lround(air) : std::lround(noisy.value(x, y, z))));
  return volume::Grid(grid.geometry(), std::move(values));
}

}  // namespace isolux::test
