#include "gi/bake_unit.h"

#include <algorithm>
#include <chrono>
#include <span>
#include <stdexcept>
#include <utility>

#include "gi/texel_bits.h"

namespace isolux::gi {

namespace {

// A call takes about this long, so that threads heed new wishes within 20 ms.
constexpr double kSecondsOfCall = 0.008;
constexpr double kFewestPaths = 256.0, kMostPaths = 65536.0;

}  // namespace

void UnitRunner::run(const BakeQueue::Unit& unit, const std::stop_token& stop, const AfterCall& leave) {
  LatticeBlock block;
  if (!lattice_.read(unit.block, block))
    block.means.assign(
        static_cast<std::size_t>(kTexelsOfBlock) * static_cast<std::size_t>(lattice_.content().components()),
        0.0f);
  changed_ = false;
  try {
    findNormals(unit, block);
    while (bring(unit, block, stop, leave)) {
    }
  } catch (...) {
    if (changed_) lattice_.write(unit.block, std::move(block));
    throw;
  }
  if (changed_) lattice_.write(unit.block, std::move(block));
}

void UnitRunner::findNormals(const BakeQueue::Unit& unit, LatticeBlock& block) {
  texels_.clear();
  indices_.clear();
  forEachTexel(unit.texels & ~block.unlit, [&](std::size_t i) {
    if (block.samples[i] > 0 || block.normals[i] != glm::vec3(0.0f)) return;
    indices_.push_back(i);
    texels_.push_back(lattice_.geometry().texelOf(unit.block, static_cast<int>(i)));
  });
  if (texels_.empty()) return;
  normals_.resize(texels_.size());
  estimator_.normals(texels_, normals_);
  for (std::size_t t = 0; t < indices_.size(); ++t) {
    block.normals[indices_[t]] = normals_[t];
    if (normals_[t] == glm::vec3(0.0f)) block.unlit.set(indices_[t]);
  }
  changed_ = true;
}

// One call of the estimator; false: nothing is left, or leave.
bool UnitRunner::bring(const BakeQueue::Unit& unit, LatticeBlock& block, const std::stop_token& stop,
                       const AfterCall& leave) {
  // Texels that have the fewest samples.
  std::uint32_t first = unit.target;
  const auto texels = unit.texels & ~block.unlit;
  forEachTexel(texels, [&](std::size_t i) { first = std::min(first, block.samples[i]); });
  if (first >= unit.target) return false;
  const std::uint32_t count = unit.target - first;
  const auto most = static_cast<std::size_t>(std::max(pathsOfCall_ / count, 1.0));
  indices_.clear();
  texels_.clear();
  normals_.clear();
  forEachTexel(texels, [&](std::size_t i) {
    if (block.samples[i] != first || indices_.size() == most) return;
    indices_.push_back(i);
    texels_.push_back(lattice_.geometry().texelOf(unit.block, static_cast<int>(i)));
    normals_.push_back(block.normals[i]);
  });
  const auto components = static_cast<std::size_t>(lattice_.content().components());
  means_.resize(indices_.size() * components);

  const auto start = std::chrono::steady_clock::now();
  std::uint64_t rays = 0;
  if (!estimator_.estimate(texels_, normals_, {first, count}, means_, rays, stop)) {
    if (!stop.stop_requested()) throw std::logic_error("an estimator of light stopped unasked");
    leave(rays, 0);
    return false;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const double paths = static_cast<double>(indices_.size()) * count;
  const double fitting = paths * kSecondsOfCall / std::max(took.count(), 1e-6);
  pathsOfCall_ = std::clamp(0.5 * (pathsOfCall_ + fitting), kFewestPaths, kMostPaths);

  const float weight = static_cast<float>(count) / static_cast<float>(unit.target);
  for (std::size_t t = 0; t < indices_.size(); ++t) {
    float* const mean = block.means.data() + indices_[t] * components;
    for (std::size_t c = 0; c < components; ++c) mean[c] += (means_[t * components + c] - mean[c]) * weight;
    block.samples[indices_[t]] = unit.target;
  }
  changed_ = true;
  return !leave(rays, static_cast<std::uint64_t>(paths));
}

}  // namespace isolux::gi
