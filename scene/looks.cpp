#include "scene/looks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace isolux::scene {

namespace {

// Koenderink & van Doorn 1992; 0 where the surface is flat.
double shapeIndexOf(double kappa1, double kappa2) {
  return std::atan2(kappa1 + kappa2, kappa1 - kappa2) * 2.0 / std::numbers::pi;
}

double curvednessOf(double kappa1, double kappa2) {
  return std::sqrt(0.5) * std::hypot(kappa1, kappa2);
}

constexpr LookInfo lookTable[] = {
    {.mode = LookMode::blinn_phong,
     .name = "blinn_phong",
     .meaning = "the surface's own colour with a highlight",
     .kind = LookKind::shading,
     .shading = Shading::blinn_phong},
    {.mode = LookMode::lambert,
     .name = "lambert",
     .meaning = "the surface's own colour, matt",
     .kind = LookKind::shading,
     .shading = Shading::lambert},
    {.mode = LookMode::tone,
     .name = "tone",
     .meaning = "cool where the surface faces away from the light, warm where it faces the light",
     .kind = LookKind::shading,
     .shading = Shading::tone},
    {.mode = LookMode::kappa1,
     .name = "kappa1",
     .meaning = "the larger principal curvature",
     .kind = LookKind::measure,
     .readsCurvature = true,
     .colors = LookColors::diverging,
     .dimension = 1,
     .measure = [](double kappa1, double) { return kappa1; },
     .quantity = "κ₁"},
    {.mode = LookMode::kappa2,
     .name = "kappa2",
     .meaning = "the smaller principal curvature",
     .kind = LookKind::measure,
     .readsCurvature = true,
     .colors = LookColors::diverging,
     .dimension = 1,
     .measure = [](double, double kappa2) { return kappa2; },
     .quantity = "κ₂"},
    {.mode = LookMode::mean_curvature,
     .name = "mean_curvature",
     .meaning = "the mean of both principal curvatures",
     .kind = LookKind::measure,
     .readsCurvature = true,
     .colors = LookColors::diverging,
     .dimension = 1,
     .measure = [](double kappa1, double kappa2) { return 0.5 * (kappa1 + kappa2); },
     .quantity = "mean"},
    {.mode = LookMode::gaussian_curvature,
     .name = "gaussian_curvature",
     .meaning =
         "the product of both principal curvatures: positive on domes and in cups, negative on saddles",
     .kind = LookKind::measure,
     .readsCurvature = true,
     .colors = LookColors::diverging,
     .dimension = 2,
     .measure = [](double kappa1, double kappa2) { return kappa1 * kappa2; },
     .quantity = "Gaussian"},
    {.mode = LookMode::shape_index,
     .name = "shape_index",
     .meaning = "the kind of shape, regardless of size: -1 cup, 0 saddle, 1 cap",
     .kind = LookKind::measure,
     .readsCurvature = true,
     .colors = LookColors::shape,
     .range = LookRange::unit,
     .measure = shapeIndexOf,
     .quantity = "shape index"},
    {.mode = LookMode::curvedness,
     .name = "curvedness",
     .meaning = "the strength of curvature, regardless of shape",
     .kind = LookKind::measure,
     .readsCurvature = true,
     .colors = LookColors::sequential,
     .range = LookRange::fromZero,
     .dimension = 1,
     .measure = curvednessOf,
     .quantity = "curvedness"},
    {.mode = LookMode::flowline_curvature,
     .name = "flowline_curvature",
     .meaning = "the curvature of the gradient's flowlines: high where the isosurface is uncertain",
     .kind = LookKind::measure,
     .readsCurvature = true,
     .readsFlowline = true,
     .colors = LookColors::sequential,
     .range = LookRange::fromZero,
     .dimension = 1,
     .quantity = "flowline"},
    {.mode = LookMode::curvature_2d,
     .name = "curvature_2d",
     .meaning = "both principal curvatures: hue shows the kind of shape, grey is flat",
     .kind = LookKind::square,
     .readsCurvature = true,
     .dimension = 1,
     .quantity = "κ₁",
     .quantityVertical = "κ₂"},
    {.mode = LookMode::accessibility,
     .name = "accessibility",
     .meaning = "crevice shading (accessibility): a light surface with dark hollows, like dirt",
     .kind = LookKind::colored,
     .readsCurvature = true},
    {.mode = LookMode::edge_offset,
     .name = "edge_offset",
     .meaning =
         "the distance from the surface to the edge of the object: positive is outside, grey has no edge",
     .kind = LookKind::measure,
     .readsEdge = true,
     .colors = LookColors::diverging,
     .dimension = -1,
     .quantity = "edge offset"},
    {.mode = LookMode::flow,
     .name = "flow",
     .meaning = "streaks along the principal curvature directions",
     .kind = LookKind::colored,
     .readsCurvature = true},
    {.mode = LookMode::gi,
     .name = "gi",
     .meaning = "the surface's own colour under baked global illumination",
     .kind = LookKind::shading,
     .shading = Shading::gi},
    {.mode = LookMode::normal,
     .name = "normal",
     .meaning = "the outward normal as a colour, world axes",
     .kind = LookKind::raw},
    {.mode = LookMode::curvature_direction,
     .name = "curvature_direction",
     .meaning = "the first principal direction as a colour: its parts along the world axes, without sign",
     .kind = LookKind::raw,
     .readsCurvature = true},
    {.mode = LookMode::depth,
     .name = "depth",
     .meaning = "the distance from the viewer, in even steps of lightness",
     .kind = LookKind::raw,
     .readsGradient = false},
};

}  // namespace

std::span<const LookInfo> looks() {
  return lookTable;
}

const LookInfo& lookInfo(LookMode mode) {
  const auto found = std::find_if(std::begin(lookTable), std::end(lookTable),
                                  [mode](const LookInfo& look) { return look.mode == mode; });
  assert(found != std::end(lookTable));
  return *found;
}

std::string_view unitOf(const LookInfo& look) {
  switch (look.dimension) {
    case 2:
      return "1/mm²";
    case 1:
      return "1/mm";
    case -1:
      return "mm";
    default:
      return "";
  }
}

}  // namespace isolux::scene
