#include "tests/properties/agreeing_hits.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "volume/field/reconstruct.h"

namespace isolux::test {

std::string textOf(const volume::Ray& ray) {
  std::ostringstream text;
  text.precision(17);
  text << "the ray from " << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " by "
       << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z;
  return text.str();
}

std::string disagreement(const TrilinearOracle& oracle, double isovalue, const volume::Ray& ray,
                         const std::optional<volume::RayHit>& found) {
  HitTally tally;
  compareHit(oracle, isovalue, ray, found, tally);
  if (tally.misses + tally.inventions == 0) return {};
  const volume::Grid& grid = oracle.grid();
  const auto expected = oracle.firstHit(isovalue, ray);
  if (found && expected) {
    const double rounding =
        1e-9 * std::max({std::abs(grid.minimum()), std::abs(grid.maximum()), std::abs(isovalue)});
    bool apart = false;
    for (int k = 0; k <= 16; ++k) {
      const double t = found->t + (*expected - found->t) * k / 16.0;
      apart = apart || !(std::abs(volume::sampleTrilinear(grid, ray.origin + t * ray.direction).value -
                                  isovalue) <= rounding);
    }
    if (!apart) return {};
  }
  std::ostringstream text;
  text.precision(17);
  text << textOf(ray) << " has a hit at " << (found ? found->t : HUGE_VAL) << ", by the search at "
       << expected.value_or(HUGE_VAL);
  return text.str();
}

}  // namespace isolux::test
