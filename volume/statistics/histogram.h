// Distribution of the values of a volume, for the isovalue slider and `isolux info`.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "volume/grid.h"

namespace isolux::volume {

struct Histogram {
  double minimum = 0.0, maximum = 0.0;  // data units: lower edge of the first bin, upper edge of the last
  std::vector<std::uint64_t> counts;    // equal bins; integer data of few values get one bin per value
  std::vector<double> peaks;            // data units, most prominent first, at most 8
  double binCentre(std::size_t bin) const;
};
// At most `bins` bins over [grid.minimum, grid.maximum]; missing voxels do not count. Multithreaded. With
// `progress` it throws Error{interrupted} once a stop was requested.
Histogram makeHistogram(const Grid& grid, int bins, base::Progress& progress);

// The classes of Otsu's two thresholds (1979), the lowest first: what part of all counts each has, its mean,
// and the borders between them, data units. No counts: no parts.
struct ValueClasses {
  std::array<double, 3> parts{}, means{};
  std::array<double, 2> borders{};
};
ValueClasses threeClasses(const Histogram& histogram);

// The first isovalue that one would look at: the border of the whole object. For CT (in HU, or int16 with the
// values of one) the skin (-300) when the range holds it. Else, where one value is much more frequent than
// others (the background), Otsu's threshold and, nearer to the background, the nearer threshold of three
// classes (Otsu 1979): 0.6 of the way from the one to the other, because what is weak at the border (leaves,
// skin in MR, a simulation's wisps) belongs to the object. Without background Otsu's threshold. Always
// strictly inside (minimum, maximum) when these differ.
double suggestIsovalue(const Grid& grid, const Histogram& histogram, const std::string& unit);

// The clearest border within the object: Otsu's threshold of the histogram without its background peak. For
// data said to be in HU the skin, as above.
double contrastIsovalue(const Grid& grid, const Histogram& histogram, const std::string& unit);

// Isovalues that each show something of its own, ascending; `first`, suggestIsovalue() or what is known
// better, is among them. For CT also skin (-300) and bone (300); else also contrastIsovalue(), the border of
// the object to its background, and, of what lies on either side of `first`, Otsu's
// threshold where that part has two classes (the variance between them is three quarters of all or more,
// which an even spread has).
std::vector<double> suggestIsovalues(const Grid& grid, const Histogram& histogram, const std::string& unit,
                                     double first);

}  // namespace isolux::volume
