// The table of looks: complete, and its measures are those of the textbooks.
#include "scene/looks.h"

#include <set>

#include <gtest/gtest.h>

namespace isolux::scene {
namespace {

TEST(Looks, EachHasItsOwnRow) {
  std::set<LookMode> modes;
  std::set<std::string_view> names;
  for (const LookInfo& look : looks()) {
    EXPECT_TRUE(modes.insert(look.mode).second) << look.name;
    EXPECT_TRUE(names.insert(look.name).second) << look.name;
    EXPECT_EQ(&lookInfo(look.mode), &look);
    EXPECT_FALSE(look.meaning.empty()) << look.name;
  }
}

TEST(Looks, WhatColoursMeanIsSaidOnALegend) {
  for (const LookInfo& look : looks()) {
    const bool numbers = look.kind == LookKind::measure || look.kind == LookKind::square;
    EXPECT_EQ(look.quantity.empty(), !numbers) << look.name;
    EXPECT_EQ(look.quantityVertical.empty(), look.kind != LookKind::square) << look.name;
    EXPECT_EQ(look.measure != nullptr || look.readsEdge || look.readsFlowline, look.kind == LookKind::measure)
        << look.name;
    EXPECT_TRUE(!look.readsCurvature || look.readsGradient) << look.name;
    EXPECT_TRUE(look.kind == LookKind::shading || look.shading == Shading::unlit) << look.name;
  }
}

// On a ridge (0.5, 0), a saddle (0.5, -0.5), a cap and a cup of radius 2.
TEST(Looks, MeasuresOfKnownShapes) {
  const auto of = [](LookMode mode, double kappa1, double kappa2) {
    return lookInfo(mode).measure(kappa1, kappa2);
  };
  EXPECT_DOUBLE_EQ(of(LookMode::shape_index, 0.5, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(of(LookMode::shape_index, 0.5, -0.5), 0.0);
  EXPECT_DOUBLE_EQ(of(LookMode::shape_index, 0.5, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(of(LookMode::shape_index, -0.5, -0.5), -1.0);
  EXPECT_DOUBLE_EQ(of(LookMode::curvedness, 0.5, -0.5), 0.5);
  EXPECT_DOUBLE_EQ(of(LookMode::mean_curvature, 0.5, 0.0), 0.25);
  EXPECT_DOUBLE_EQ(of(LookMode::gaussian_curvature, 0.5, -0.5), -0.25);
  EXPECT_DOUBLE_EQ(of(LookMode::kappa1, 0.5, -0.25), 0.5);
  EXPECT_DOUBLE_EQ(of(LookMode::kappa2, 0.5, -0.25), -0.25);
}

TEST(Looks, UnitsFollowTheDimension) {
  EXPECT_EQ(unitOf(lookInfo(LookMode::kappa1)), "1/mm");
  EXPECT_EQ(unitOf(lookInfo(LookMode::gaussian_curvature)), "1/mm²");
  EXPECT_EQ(unitOf(lookInfo(LookMode::shape_index)), "");
  EXPECT_EQ(unitOf(lookInfo(LookMode::edge_offset)), "mm");
}

}  // namespace
}  // namespace isolux::scene
