#include "volume/color/second_values.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "base/quantiles.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {

namespace {

constexpr double kStepVoxels = 0.5;
constexpr int kMostStepsBelow = 2000;
constexpr double kSlack = 1e-6;  // voxels: a point on the border that rounding has put outside

}  // namespace

SecondValues::SecondValues(std::shared_ptr<const SecondVolume> volume, scene::Field field)
    : volume_(std::move(volume)),
      field_(field),
      voxelFromWorld_(volume_->grid().geometry().voxelFromWorld()) {}

std::optional<SecondValue> SecondValues::at(const glm::dvec3& worldMm) const {
  const glm::dvec3 voxel(voxelFromWorld_ * glm::dvec4(worldMm, 1.0));
  if (!volume_->grid().geometry().holds(voxel, kSlack)) return std::nullopt;
  const bool fromCoefficients = field_ == scene::Field::cubic_interpolating;
  const FieldSample sample =
      sampleField(volume_->grid(), field_, fromCoefficients ? volume_->coefficients.get() : nullptr, voxel);
  if (std::isnan(sample.value)) return std::nullopt;
  return SecondValue{sample.value, glm::transpose(glm::dmat3(voxelFromWorld_)) * sample.gradient};
}

std::optional<SecondValue> SecondValues::largestBelow(const glm::dvec3& worldMm, const glm::dvec3& inward,
                                                      double mm) const {
  const glm::dvec3 along = glm::dmat3(voxelFromWorld_) * inward;
  const double voxels = mm * std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
  const int steps = std::clamp(static_cast<int>(std::ceil(voxels / kStepVoxels)), 1, kMostStepsBelow);
  const double step = mm / steps;
  const auto valueAt = [&](double s) { return at(worldMm + s * inward); };
  std::optional<SecondValue> last, largest, before, after;  // beside the largest one
  double largestAt = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const std::optional<SecondValue> here = valueAt(i * step);
    if (here && (!largest || here->value > largest->value)) {
      largest = here;
      largestAt = i * step;
      before = last;
      after.reset();
    } else if (here && largest && largestAt == (i - 1) * step) {
      after = here;
    }
    last = here;
  }
  if (!largest) return largest;
  // The top lies toward the neighbour that the value rises to.
  const double rise = glm::dot(largest->gradient, inward), toward = rise > 0.0 ? 1.0 : -1.0;
  const std::optional<SecondValue>& beside = rise > 0.0 ? after : before;
  if (!beside) return largest;
  const double slope = std::abs(rise) * step;
  const double bend = largest->value + slope - beside->value;  // of value + slope t - bend t^2
  if (!(bend > 0.0)) return largest;
  const std::optional<SecondValue> top =
      valueAt(largestAt + toward * step * std::min(0.5 * slope / bend, 1.0));
  return top && top->value > largest->value ? top : largest;
}

std::optional<Quantiles> rangeOf(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  std::vector<double> sorted(values.begin(), values.end());
  return Quantiles{base::lowerQuantile(sorted, 0.02), base::lowerQuantile(sorted, 0.5),
                   base::lowerQuantile(sorted, 0.98)};
}

}  // namespace isolux::volume
