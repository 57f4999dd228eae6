#include "volume/cast/surface_derivatives.h"

#include <algorithm>
#include <cassert>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <glm/matrix.hpp>

#include "volume/cast/cast_kernels.h"

namespace isolux::volume {

void surfaceDerivatives(const Grid& grid, DerivedField field, const Coefficients* coefficients,
                        std::span<const glm::vec4> points, const DerivativeImages& images,
                        TracerTarget wanted, const std::stop_token& stop) {
  const casting::CastKernels* const kernels = casting::castKernels(wanted);
  assert(kernels && images.gradient.size() == points.size());
  assert(images.diagonal.size() == images.mixed.size());
  casting::DerivativesView view;
  view.dims = grid.dims();
  view.cubic = field == DerivedField::spline;
  std::visit([&](const auto& voxels) { view.samples = voxels.data(); }, grid.voxels());
  view.spline = view.samples;
  if (coefficients) view.spline = coefficients->values.data();
  view.worldFromVoxel = glm::mat3(glm::transpose(glm::inverse(glm::dmat3(grid.geometry().worldFromVoxel))));
  view.dataUnits = static_cast<float>(grid.slope());
  constexpr std::size_t piece = 4096;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), piece), [&](const auto& range) {
    if (stop.stop_requested()) return;
    const auto part = [&](std::span<glm::vec4> image) {
      return image.empty() ? nullptr : image.data() + range.begin();
    };
    kernels->derivatives(view, {points.data() + range.begin(), range.size(), part(images.gradient),
                                part(images.diagonal), part(images.mixed)});
  });
}

}  // namespace isolux::volume
