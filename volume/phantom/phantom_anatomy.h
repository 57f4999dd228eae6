// The organs of the head phantom as solids, in mm, patient axes (LPS), origin between the ear canals.
#pragma once

#include <array>

#include "volume/phantom/phantom_shapes.h"

namespace isolux::volume {

enum class Organ {
  flesh,
  brain,
  ventricles,
  orbits,
  eyes,
  lenses,
  airways,
  skull,
  mandible,
  spine,
  teeth,
  sinuses,
  marker
};
inline constexpr std::size_t kOrganCount = 13;

struct Anatomy {
  std::array<Solid, kOrganCount> organs;
  Solid& operator[](Organ organ) { return organs[static_cast<std::size_t>(organ)]; }
};

Anatomy makeAnatomy();

}  // namespace isolux::volume
