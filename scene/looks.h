// The table of looks: each value of look.mode once, with all that follows from it.
//
// From here come the choices of the setting, the rules of relevance, GLSL constants, colour maps and their
// automatic ranges, legends, the window's list of looks and the table in docs/reference/settings.md.
#pragma once

#include <span>
#include <string_view>

#include "scene/choices.h"

namespace isolux::scene {

enum class LookKind {
  shading,  // the surface's own colour under a shading of the look's own
  colored,  // made from the surface's own colour, under look.shading
  measure,  // colours stand for a number, under look.shading
  square,   // colours stand for a pair of numbers, kappa1 and kappa2, under look.shading
  raw       // a raw quantity, with nothing laid over it
};

// Where the ends of a colour map lie when they are automatic.
enum class LookRange {
  symmetric,  // around 0, as far as the surface's values go
  fromZero,   // to the largest of them
  unit        // -1 to 1, whatever the surface
};

// The colours of an automatic map.
enum class LookColors { diverging, sequential, shape };  // shape: after Koenderink & van Doorn 1992

struct LookInfo {
  LookMode mode;
  std::string_view name;     // in look.mode; LOOK_NAME in shaders
  std::string_view meaning;  // a clause: what is seen
  LookKind kind;
  bool readsGradient = true;
  bool readsCurvature = false;
  bool readsEdge = false;            // where the object's edge is (volume/edge)
  Shading shading = Shading::unlit;  // of kind shading

  // Of kinds measure and square:
  LookColors colors = LookColors::sequential;
  LookRange range = LookRange::symmetric;
  int dimension = 0;                                      // of the measure: 1/mm to this power; mm: -1
  double (*measure)(double, double) = nullptr;            // of kappa1 >= kappa2, 1/mm; null for others
  std::string_view quantity = {}, quantityVertical = {};  // on the legend
};

// In the order in which users are offered them.
std::span<const LookInfo> looks();
const LookInfo& lookInfo(LookMode mode);

// On the legend: "1/mm", "1/mm²", "mm" or nothing.
std::string_view unitOf(const LookInfo& look);

}  // namespace isolux::scene
