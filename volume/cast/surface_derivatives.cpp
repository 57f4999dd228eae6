#include "volume/cast/surface_derivatives.h"

#include <algorithm>
#include <cassert>

#include <glm/matrix.hpp>

#include "volume/cast/cast_kernels.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

casting::DerivativesView viewOf(const Grid& grid) {
  casting::DerivativesView view;
  view.dims = grid.dims();
  std::visit([&](const auto& voxels) { view.samples = voxels.data(); }, grid.voxels());
  view.spline = view.samples;
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

void derive(const casting::DerivativesView& view, std::span<const glm::vec4> points, const PictureArea& area,
            const DerivativeImages& images, TracerTarget wanted, const std::stop_token& stop) {
  const casting::CastKernels* const kernels = casting::castKernels(wanted);
  assert(kernels && images.gradient.size() == points.size());
  assert(points.size() == static_cast<std::size_t>(area.size().x) * static_cast<std::size_t>(area.size().y));
  assert(images.diagonal.size() == images.mixed.size());
  deriveRows(area, stop, [&](std::size_t first, std::size_t count) {
    const auto of = [&](std::span<glm::vec4> image) { return image.empty() ? nullptr : &image[first]; };
    kernels->derivatives(view,
                         {&points[first], count, of(images.gradient), of(images.diagonal), of(images.mixed)});
  });
}

}  // namespace

void surfaceDerivatives(const Grid& grid, DerivedField field, const Coefficients* coefficients,
                        std::span<const glm::vec4> points, const PictureArea& area,
                        const DerivativeImages& images, TracerTarget wanted, const std::stop_token& stop) {
  casting::DerivativesView view = viewOf(grid);
  view.cubic = field == DerivedField::spline;
  if (coefficients) view.spline = coefficients->values.data();
  derive(view, points, area, images, wanted, stop);
}

void surfaceDerivatives(const Grid& grid, const ScaledField& scaled, std::span<const glm::vec4> points,
                        const PictureArea& area, const DerivativeImages& images, TracerTarget wanted,
                        const std::stop_token& stop) {
  casting::DerivativesView view = viewOf(grid);
  view.scaled = scaled.coefficients.values.data();
  derive(view, points, area, images, wanted, stop);
}

void surfaceEdges(const Grid& grid, const ScaledField* scaled, const Coefficients* coefficients,
                  const EdgeSearch<float>& search, std::span<const glm::vec4> points, const PictureArea& area,
                  std::span<glm::vec2> edges, float none, TracerTarget wanted, const std::stop_token& stop) {
  const casting::CastKernels* const kernels = casting::castKernels(wanted);
  assert(kernels && edges.size() == points.size());
  casting::EdgeView view{viewOf(grid), search, grid.missingCount() > 0};
  if (scaled) view.field.scaled = scaled->coefficients.values.data();
  if (coefficients) view.field.spline = coefficients->values.data();
  deriveRows(area, stop, [&](std::size_t first, std::size_t count) {
    kernels->edges(view, {&points[first], count, &edges[first], none});
  });
}

}  // namespace isolux::volume
