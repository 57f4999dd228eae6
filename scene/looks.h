// Provides the table of looks: each value of look.mode once, with everything derived from it.
//
// It determines the choices of the setting, the rules of relevance, GLSL constants, colour maps and their
// automatic ranges. Legends, the window's list of looks and the table in docs/reference/settings.md also come
// from it.
#pragma once

#include <span>
#include <string_view>

#include "scene/choices.h"

namespace isolux::scene {

enum class LookKind {
  shading,  // the surface's own colour under the look's own shading
  colored,  // made from the surface's own colour, under look.shading
  measure,  // colours show a number, under look.shading
  square,   // colours show a pair of numbers, kappa1 and kappa2, under look.shading
  raw       // a raw quantity without shading and overlays
};

// The automatic ends of a colour map.
enum class LookRange {
  symmetric,  // around 0, up to the surface's largest absolute value
  fromZero,   // from 0 to the surface's largest value
  unit        // -1 to 1 for every surface
};

// The colours of an automatic map.
enum class LookColors { diverging, sequential, shape };  // shape: after Koenderink & van Doorn 1992

struct LookInfo {
  LookMode mode;
  std::string_view name;     // in look.mode; LOOK_NAME in shaders
  std::string_view meaning;  // a clause that says what is visible
  LookKind kind;
  bool readsGradient = true;
  bool readsCurvature = false;
  bool readsFlowline = false;        // the curvature of the gradient's flowlines (volume/field/curvature.h)
  bool readsEdge = false;            // the position of the object's edge (volume/edge)
  Shading shading = Shading::unlit;  // of kind shading

  // For kinds measure and square:
  LookColors colors = LookColors::sequential;
  LookRange range = LookRange::symmetric;
  int dimension = 0;                                      // of the measure: 1/mm to this power; mm: -1
  double (*measure)(double, double) = nullptr;            // of kappa1 >= kappa2, 1/mm; null for others
  std::string_view quantity = {}, quantityVertical = {};  // on the legend
};

// Returns all looks in the order in which users see them.
std::span<const LookInfo> looks();
const LookInfo& lookInfo(LookMode mode);

// Returns the unit for the legend: "1/mm", "1/mm²", "mm" or "".
std::string_view unitOf(const LookInfo& look);

}  // namespace isolux::scene
