#include "scene/looks.h"

#include <cmath>
#include <cstddef>
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

constexpr LookInfo shadingLook(LookMode mode, Shading shading, std::string_view name,
                               std::string_view meaning) {
  return {.mode = mode, .name = name, .meaning = meaning, .kind = LookKind::shading, .shading = shading};
}

// Colours show a number of kappa1 >= kappa2, in 1/mm to the power `dimension`.
constexpr LookInfo curvatureLook(LookMode mode, std::string_view name, std::string_view meaning,
                                 std::string_view quantity, LookColors colors, LookRange range, int dimension,
                                 double (*measure)(double, double)) {
  return {.mode = mode,
          .name = name,
          .meaning = meaning,
          .kind = LookKind::measure,
          .readsCurvature = true,
          .colors = colors,
          .range = range,
          .dimension = dimension,
          .measure = measure,
          .quantity = quantity};
}

// In the order of LookMode.
constexpr LookInfo lookTable[] = {
    shadingLook(LookMode::blinn_phong, Shading::blinn_phong, "blinn_phong",
                "the surface's own colour with a highlight"),
    shadingLook(LookMode::lambert, Shading::lambert, "lambert", "the surface's own colour, matt"),
    shadingLook(LookMode::tone, Shading::tone, "tone",
                "cool where the surface faces away from the light, warm where it faces the light"),
    curvatureLook(LookMode::kappa1, "kappa1", "the larger principal curvature", "κ₁", LookColors::diverging,
                  LookRange::symmetric, 1, [](double kappa1, double) { return kappa1; }),
    curvatureLook(LookMode::kappa2, "kappa2", "the smaller principal curvature", "κ₂", LookColors::diverging,
                  LookRange::symmetric, 1, [](double, double kappa2) { return kappa2; }),
    curvatureLook(LookMode::mean_curvature, "mean_curvature", "the mean of both principal curvatures", "mean",
                  LookColors::diverging, LookRange::symmetric, 1,
                  [](double kappa1, double kappa2) { return 0.5 * (kappa1 + kappa2); }),
    curvatureLook(
        LookMode::gaussian_curvature, "gaussian_curvature",
        "the product of both principal curvatures: positive on domes and in cups, negative on saddles",
        "Gaussian", LookColors::diverging, LookRange::symmetric, 2,
        [](double kappa1, double kappa2) { return kappa1 * kappa2; }),
    curvatureLook(LookMode::shape_index, "shape_index",
                  "the kind of shape, regardless of size: -1 cup, 0 saddle, 1 cap", "shape index",
                  LookColors::shape, LookRange::unit, 0, shapeIndexOf),
    curvatureLook(LookMode::curvedness, "curvedness", "the strength of curvature, regardless of shape",
                  "curvedness", LookColors::sequential, LookRange::fromZero, 1, curvednessOf),
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
    shadingLook(LookMode::gi, Shading::gi, "gi", "the surface's own colour under baked global illumination"),
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
  return lookTable[static_cast<std::size_t>(mode)];
}

std::string_view unitOf(const LookInfo& look) {
  if (look.dimension == 2) return "1/mm²";
  return look.dimension == 1 ? "1/mm" : look.dimension == -1 ? "mm" : "";
}

}  // namespace isolux::scene
