#include "volume/statistics/plausibility.h"

namespace isolux::volume {

namespace {

// The part of all voxels with values in [low, high).
double share(const Histogram& histogram, double low, double high) {
  double inside = 0.0, all = 0.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const auto count = static_cast<double>(histogram.counts[bin]);
    const double value = histogram.binCentre(bin);
    all += count;
    if (low <= value && value < high) inside += count;
  }
  return all > 0.0 ? inside / all : 0.0;
}

}  // namespace

bool looksOffsetBy1024(const Histogram& histogram, double minimum) {
  constexpr double enough = 0.05;
  const double air = share(histogram, 0.0, 150.0), between = share(histogram, 250.0, 750.0),
               tissue = share(histogram, 900.0, 1200.0);
  return minimum >= 0.0 && air >= enough && tissue >= enough && between < tissue;
}

}  // namespace isolux::volume
