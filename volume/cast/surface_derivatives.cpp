#include "volume/cast/surface_derivatives.h"

#include <cassert>

#include <glm/matrix.hpp>

#include "volume/cast/cast_kernels.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

casting::DerivativesView viewOf(const Grid& grid, const DerivedField& field) {
  casting::DerivativesView view;
  view.dims = grid.dims();
  grid.visit([&](const auto& voxels) { view.samples = voxels.data(); });
  view.spline = view.samples;
  if (field.coefficients) view.spline = field.coefficients->values.data();
  if (field.scaled) view.scaled = field.scaled->coefficients.values.data();
  view.cubic = !field.trilinear;
  view.worldFromVoxel = glm::mat3(glm::transpose(glm::inverse(glm::dmat3(grid.geometry().worldFromVoxel))));
  view.dataUnits = static_cast<float>(grid.slope());
  return view;
}

// deriveRow(first point of a row's part, points) for all of the area.
template <class DeriveRow>
void deriveRows(const PictureArea& area, const std::stop_token& stop, const DeriveRow& deriveRow) {
  const auto width = static_cast<std::size_t>(area.size().x);
  const std::vector<Rectangle> parts = area.rectangles();
  parallelEach(parts.size(), [&](std::size_t i) {
    constexpr int grain = 8;  // rows
    parallelRanges(parts[i].size.y, grain, [&](const Indices<int>& rows) {
      for (int y = rows.begin(); y < rows.end() && !stop.stop_requested(); ++y)
        deriveRow(
            static_cast<std::size_t>(parts[i].low.y + y) * width + static_cast<std::size_t>(parts[i].low.x),
            static_cast<std::size_t>(parts[i].size.x));
    });
  });
}

}  // namespace

void surfaceDerivatives(const Grid& grid, const DerivedField& field, std::span<const glm::vec4> points,
                        const PictureArea& area, const DerivativeImages& images, TracerTarget wanted,
                        const std::stop_token& stop) {
  const casting::CastKernels* const kernels = casting::castKernels(wanted);
  assert(kernels && images.gradient.size() == points.size());
  assert(points.size() == Extent2{area.size()}.count());
  assert(images.diagonal.size() == images.mixed.size());
  const casting::DerivativesView view = viewOf(grid, field);
  deriveRows(area, stop, [&](std::size_t first, std::size_t count) {
    const auto of = [&](std::span<glm::vec4> image) { return image.empty() ? nullptr : &image[first]; };
    kernels->derivatives(view,
                         {&points[first], count, of(images.gradient), of(images.diagonal), of(images.mixed)});
  });
}

void surfaceEdges(const Grid& grid, const DerivedField& field, const EdgeSearch<float>& search,
                  std::span<const glm::vec4> points, const PictureArea& area, std::span<glm::vec2> edges,
                  float none, TracerTarget wanted, const std::stop_token& stop) {
  const casting::CastKernels* const kernels = casting::castKernels(wanted);
  assert(kernels && edges.size() == points.size());
  const casting::EdgeView view{viewOf(grid, field), search, grid.missingCount() > 0};
  deriveRows(area, stop, [&](std::size_t first, std::size_t count) {
    kernels->edges(view, {&points[first], count, &edges[first], none});
  });
}

}  // namespace isolux::volume
