#include "volume/statistics/noise_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>

#include "base/random.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr std::uint64_t kPlaces = 240000;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// Runs along x: what takes long is to fetch a voxel from far away, its neighbours come with it.
glm::ivec3 randomVoxel(glm::ivec3 dims, std::uint64_t number) {
  constexpr std::uint64_t run = 6;
  constexpr int step = 4;
  glm::ivec3 at;
  for (int i = 0; i < 3; ++i)
    at[i] = static_cast<int>(
        base::uniformNoise(std::uint64_t{17} + static_cast<std::uint64_t>(i), number / run) * dims[i]);
  at.x = (at.x + step * static_cast<int>(number % run)) % dims.x;
  return at;
}

template <class T>
class NoiseSampler {
 public:
  NoiseSampler(const Grid& grid, const std::vector<T>& voxels, double mostFrequent)
      : grid_(grid),
        voxels_(voxels),
        dims_(grid.dims()),
        constants_{grid.storedMinimum(), grid.storedMaximum(), mostFrequent} {}

  // Steepness is NaN where much is set to one value.
  NoiseSample at(std::uint64_t number) const {
    const glm::ivec3 at = randomVoxel(dims_, number);
    NoiseSample place{.number = number};
    double values = 0.0;
    int opposite = 0, set = isSet(stored(at)) ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Opposite pair = oppositeAlong(at, axis);
      if (pair.distance == 0) continue;
      const double odd = (pair.after - pair.before) / pair.distance;
      place.steepness += odd * odd;
      values += 0.5 * (pair.after + pair.before);
      set += pair.set;
      ++opposite;
    }
    place.value = values / opposite;
    if (set >= 2) place.steepness = kNotANumber;
    return place;
  }

  NoiseDifferences differencesAt(std::uint64_t number) const {
    const glm::ivec3 at = randomVoxel(dims_, number);
    NoiseDifferences differences{};
    for (int axis = 0; axis < 3; ++axis)
      for (int spacing = 1; spacing <= kNoiseSpacings; ++spacing)
        differences[static_cast<std::size_t>(axis)][static_cast<std::size_t>(spacing - 1)] =
            std::abs(fourthAlong(at, axis, spacing));
    return differences;
  }

 private:
  double stored(glm::ivec3 at) const { return static_cast<double>(voxels_[grid_.index(at)]); }
  double dithered(glm::ivec3 at) const {
    const std::size_t index = grid_.index(at);
    const auto value = static_cast<double>(voxels_[index]);
    if constexpr (std::is_integral_v<T>)
      return value + 0x1p-32 * static_cast<double>(base::hash32(index)) - 0.5;
    else
      return value;
  }
  bool isSet(double value) const {
    return std::find(std::begin(constants_), std::end(constants_), value) != std::end(constants_);
  }
  bool reaches(glm::ivec3 at, int axis, int reach) const {
    return at[axis] >= reach && at[axis] + reach < dims_[axis];
  }

  struct Opposite {
    double before = 0.0, after = 0.0;
    int distance = 0;  // voxels between them
    int set = 0;       // how many are set to one value
  };
  Opposite oppositeAlong(glm::ivec3 at, int axis) const {
    for (int reach = kNoiseSpacings; reach > 0; --reach) {
      if (!reaches(at, axis, reach)) continue;
      glm::ivec3 step(0);
      step[axis] = reach;
      const int set = (isSet(stored(at - step)) ? 1 : 0) + (isSet(stored(at + step)) ? 1 : 0);
      return {dithered(at - step), dithered(at + step), 2 * reach, set};
    }
    return {};
  }

  double fourthAlong(glm::ivec3 at, int axis, int spacing) const {
    static constexpr double weights[] = {1, -4, 6, -4, 1};
    if (!reaches(at, axis, 2 * spacing)) return secondAlong(at, axis, spacing);
    double sum = 0.0;
    int set = 0;
    for (int tap = 0; tap < 5; ++tap) {
      glm::ivec3 p = at;
      p[axis] += (tap - 2) * spacing;
      set += isSet(stored(p)) ? 1 : 0;
      sum += weights[tap] * dithered(p);
    }
    return set >= 2 ? kNotANumber : sum / std::sqrt(70.0);
  }

  // Of axes that have no room for fourth differences.
  double secondAlong(glm::ivec3 at, int axis, int spacing) const {
    if (dims_[axis] >= 5 || !reaches(at, axis, spacing)) return kNotANumber;
    glm::ivec3 step(0);
    step[axis] = spacing;
    const int set =
        (isSet(stored(at - step)) ? 1 : 0) + (isSet(stored(at)) ? 1 : 0) + (isSet(stored(at + step)) ? 1 : 0);
    return set >= 2 ? kNotANumber
                    : (dithered(at - step) - 2.0 * dithered(at) + dithered(at + step)) / std::sqrt(6.0);
  }

  const Grid& grid_;
  const std::vector<T>& voxels_;
  glm::ivec3 dims_;
  double constants_[3];
};

// Of those that stand side by side; NaN where no voxel equals its neighbour.
double mostFrequentConstant(const Grid& grid) {
  const glm::ivec3 dims = grid.dims();
  std::map<double, int> counts;
  for (std::uint64_t i = 0; i < kPlaces / 4; ++i) {
    const glm::ivec3 at = randomVoxel(dims, i);
    if (at.x + 1 >= dims.x) continue;
    const double value = grid.stored(at);
    if (value == grid.stored(at.x + 1, at.y, at.z)) ++counts[value];
  }
  const auto most = std::ranges::max_element(counts, {}, &std::pair<const double, int>::second);
  return most == counts.end() ? kNotANumber : most->first;
}

}  // namespace

NoiseSamples::NoiseSamples(const Grid& grid) : grid_(grid), mostFrequent_(mostFrequentConstant(grid)) {}

std::vector<NoiseSample> NoiseSamples::list(base::Progress& progress) const {
  std::vector<NoiseSample> places(std::min<std::uint64_t>(kPlaces, 4 * grid_.geometry().voxelCount()));
  grid_.visit([&](const auto& voxels) {
    const NoiseSampler sampler(grid_, voxels, mostFrequent_);
    parallelPieces(places.size(), 4096, progress, {}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) places[i] = sampler.at(i);
    });
  });
  std::erase_if(places, [](const NoiseSample& place) {
    return std::isnan(place.value) || std::isnan(place.steepness);
  });
  return places;
}

std::vector<NoiseDifferences> NoiseSamples::differencesAt(std::span<const NoiseSample> places,
                                                          base::Progress& progress) const {
  std::vector<NoiseDifferences> list(places.size());
  grid_.visit([&](const auto& voxels) {
    const NoiseSampler sampler(grid_, voxels, mostFrequent_);
    parallelPieces(places.size(), 512, progress, {}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) list[i] = sampler.differencesAt(places[i].number);
    });
  });
  return list;
}

}  // namespace isolux::volume
