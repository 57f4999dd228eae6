#include "gi/bake/bake_unit.h"

#include <algorithm>
#include <chrono>
#include <span>
#include <stdexcept>
#include <utility>

#include "gi/lattice/texel_bits.h"

namespace isolux::gi {

namespace {

// A call takes about this long, so that threads heed new requests within 20 ms.
constexpr double kSecondsOfCall = 0.008;
constexpr double kFewestPaths = 16.0, kMostPaths = 65536.0;

}  // namespace

void UnitRunner::run(const BakeQueue::Unit& unit, const std::stop_token& stop, const AfterCall& leave) {
  LatticeBlock block;
  if (const auto before = lattice_.at(unit.block))
    block = *before;
  else
    block = lattice_.dark();
  changed_ = false;
  try {
    findPoints(unit, block);
    while (bring(unit, block, stop, leave)) {
    }
  } catch (...) {
    if (changed_) lattice_.write(unit.block, std::move(block));
    throw;
  }
  if (changed_) lattice_.write(unit.block, std::move(block));
}

void UnitRunner::findPoints(const BakeQueue::Unit& unit, LatticeBlock& block) {
  texels_.clear();
  indices_.clear();
  forEachTexel(unit.texels & ~block.unlit, [&](std::size_t i) {
    if (block.samples[i] > 0 || block.normals[i] != glm::vec3(0.0f)) return;
    indices_.push_back(i);
    texels_.push_back(lattice_.geometry().texelOf(unit.block, static_cast<int>(i)));
  });
  if (texels_.empty()) return;
  points_.resize(texels_.size());
  estimator_.points(texels_, points_);
  for (std::size_t t = 0; t < indices_.size(); ++t) {
    const std::size_t i = indices_[t];
    block.normals[i] = points_[t].normal;
    if (!block.places.empty()) block.places[i] = points_[t].voxel;
    if (points_[t].normal == glm::vec3(0.0f)) block.unlit.set(i);
  }
  changed_ = true;
}

// Brings the texels that have the fewest samples, or some of them, to the unit's target; false: nothing is
// left, or leave.
bool UnitRunner::bring(const BakeQueue::Unit& unit, LatticeBlock& block, const std::stop_token& stop,
                       const AfterCall& leave) {
  std::uint32_t first = unit.target;
  forEachTexel(unit.texels & ~block.unlit, [&](std::size_t i) { first = std::min(first, block.samples[i]); });
  if (first >= unit.target) return false;
  choose(unit, block, first);
  bool left = false;
  while (!left && round_.done < round_.count) {
    const std::uint32_t paths = round_.count - round_.done;
    const auto most = static_cast<std::uint32_t>(std::clamp(
        pathsOfCall_ / static_cast<double>(round_.texels.size()), 1.0, static_cast<double>(paths)));
    if (!addPaths(round_.texels.size() > 1 ? paths : most, stop, leave, left)) return false;
  }
  if (round_.done == round_.count) store(block, unit.target);
  return !left;
}

// What the next calls are about: as many texels as fit into one, or what was begun before.
void UnitRunner::choose(const BakeQueue::Unit& unit, const LatticeBlock& block, std::uint32_t first) {
  const std::uint32_t count = unit.target - first;
  const auto wanted = unit.texels & ~block.unlit;
  const auto goesOn = [&] {
    return round_.count == count && round_.block == unit.block && round_.first == first &&
           std::all_of(round_.indices.begin(), round_.indices.end(),
                       [&](std::size_t i) { return wanted[i] && block.samples[i] == first; });
  };
  if (goesOn()) return;
  const auto most = static_cast<std::size_t>(std::max(pathsOfCall_ / count, 1.0));
  round_.block = unit.block;
  round_.first = first;
  round_.count = count;
  round_.done = 0;
  round_.indices.clear();
  round_.texels.clear();
  round_.points.clear();
  forEachTexel(wanted, [&](std::size_t i) {
    if (block.samples[i] != first || round_.indices.size() == most) return;
    round_.indices.push_back(i);
    const glm::ivec3 texel = lattice_.geometry().texelOf(unit.block, static_cast<int>(i));
    round_.texels.push_back(texel);
    const glm::vec3 place = block.places.empty() ? lattice_.geometry().voxelOf(texel) : block.places[i];
    round_.points.push_back({place, block.normals[i]});
  });
  round_.sums.assign(round_.indices.size() * static_cast<std::size_t>(lattice_.content().components()), 0.0);
}

// One call of the estimator; false: it was stopped. `left`: go no further after it.
bool UnitRunner::addPaths(std::uint32_t count, const std::stop_token& stop, const AfterCall& leave,
                          bool& left) {
  const auto start = std::chrono::steady_clock::now();
  const std::uint32_t done = std::exchange(round_.done, 0), all = std::exchange(round_.count, 0);
  std::uint64_t rays = 0;
  if (!estimator_.add(round_.texels, round_.points, {round_.first + done, count}, round_.sums, rays, stop)) {
    if (!stop.stop_requested()) throw std::logic_error("an estimator of light stopped unasked");
    leave(rays, 0);
    return false;
  }
  round_.done = done + count;
  round_.count = all;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const double paths = static_cast<double>(round_.texels.size()) * count;
  const double fitting = paths * kSecondsOfCall / std::max(took.count(), 1e-6);
  pathsOfCall_ = std::clamp(0.5 * (pathsOfCall_ + fitting), kFewestPaths, kMostPaths);
  left = leave(rays, static_cast<std::uint64_t>(paths));
  return true;
}

void UnitRunner::store(LatticeBlock& block, std::uint32_t target) {
  const auto components = static_cast<std::size_t>(lattice_.content().components());
  const float weight = static_cast<float>(round_.count) / static_cast<float>(target);
  for (std::size_t t = 0; t < round_.indices.size(); ++t) {
    float* const mean = block.means.data() + round_.indices[t] * components;
    for (std::size_t c = 0; c < components; ++c) {
      const auto meanOfRound = static_cast<float>(round_.sums[t * components + c] / round_.count);
      mean[c] += (meanOfRound - mean[c]) * weight;
    }
    block.samples[round_.indices[t]] = target;
  }
  round_.count = 0;
  changed_ = true;
}

}  // namespace isolux::gi
