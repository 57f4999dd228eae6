#include "gi/harmonics/bit_allocation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace isolux::gi {

namespace {

// A range that leaves out none of some numbers goes beyond them by this part of it, for others to come.
constexpr double kMargin = 0.03;
// Parts of the numbers that ranges leave out, half of them at either end.
constexpr std::array<double, 11> kLeftOut = {0.0, 1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.02, 0.04, 0.08, 0.15, 0.3};

double squaredErrorOf(const Quantizer& quantizer, int bits, std::span<const double> numbers) {
  double sum = 0.0;
  for (const double number : numbers) {
    const double apart = quantizer.low + codeOf(quantizer, bits, number) * quantizer.step - number;
    sum += apart * apart;
  }
  return sum / static_cast<double>(numbers.size());
}

// Steps of equal width between the numbers with `cut` before them and behind them; a code stands for the
// middle of its step.
Quantizer evenQuantizer(std::span<const double> sorted, std::size_t cut, int bits) {
  const double low = sorted[cut], high = sorted[sorted.size() - 1 - cut];
  const double margin = cut == 0 ? kMargin * (high - low) : 0.0;
  const double step = (high - low + 2.0 * margin) / std::ldexp(1.0, bits);
  return {low - margin + 0.5 * step, std::max(step, 0.0), 0.0};
}

// What the error of one component falls to by more bits, computed as far as it is asked for.
class ErrorsByBits {
 public:
  explicit ErrorsByBits(std::span<const double> sorted) : sorted_(sorted) {}
  double operator()(int bits) {
    while (static_cast<int>(errors_.size()) <= bits)
      errors_.push_back(quantizerOf(sorted_, static_cast<int>(errors_.size())).squaredError);
    return errors_[static_cast<std::size_t>(bits)];
  }

 private:
  std::span<const double> sorted_;
  std::vector<double> errors_;
};

}  // namespace

std::uint32_t codeOf(const Quantizer& quantizer, int bits, double number) {
  const double at = quantizer.step > 0.0 ? (number - quantizer.low) / quantizer.step : 0.0;
  // NaN becomes 0.
  return static_cast<std::uint32_t>(std::min(at > 0.0 ? at : 0.0, std::ldexp(1.0, bits) - 1.0) + 0.5);
}

Quantizer quantizerOf(std::span<const double> sorted, int bits) {
  if (sorted.empty()) return {};
  const auto count = static_cast<double>(sorted.size());
  const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / count;
  Quantizer best{mean, 0.0, 0.0};
  best.squaredError = squaredErrorOf(best, 0, sorted);
  if (bits == 0) return best;
  for (const double part : kLeftOut) {
    const auto cut = static_cast<std::size_t>(0.5 * part * count);
    Quantizer quantizer = evenQuantizer(sorted, cut, bits);
    quantizer.squaredError = squaredErrorOf(quantizer, bits, sorted);
    if (quantizer.squaredError < best.squaredError) best = quantizer;
  }
  return best;
}

std::vector<int> allocateBits(const std::vector<std::vector<double>>& sorted, int total) {
  std::vector<ErrorsByBits> errors(sorted.begin(), sorted.end());
  std::vector<int> bits(sorted.size(), 0);
  while (total > 0) {
    std::size_t chosen = 0;
    int more = 0;
    double most = 0.0;  // that a bit brings
    for (std::size_t k = 0; k < bits.size(); ++k)
      // The first bit of a component may bring little where the second brings much.
      for (int add = 1; add <= std::min({2, total, kMostFieldBits - bits[k]}); ++add) {
        const double gain = (errors[k](bits[k]) - errors[k](bits[k] + add)) / add;
        if (gain <= most) continue;
        most = gain;
        chosen = k;
        more = add;
      }
    if (more == 0) break;
    bits[chosen] += more;
    total -= more;
  }
  return bits;
}

std::vector<FieldPlace> placeFields(std::vector<int>& bits, int words) {
  std::vector<std::size_t> widest(bits.size());
  std::iota(widest.begin(), widest.end(), std::size_t{0});
  std::stable_sort(widest.begin(), widest.end(),
                   [&](std::size_t a, std::size_t b) { return bits[a] > bits[b]; });
  std::vector<int> used(static_cast<std::size_t>(words), 0);
  std::vector<FieldPlace> places(bits.size());
  for (const std::size_t k : widest) {
    if (bits[k] == 0) continue;
    // The fullest word with room for it, else the emptiest.
    int best = -1;
    for (int word = 0; word < words; ++word) {
      const int here = used[static_cast<std::size_t>(word)];
      const bool fits = here + bits[k] <= kWordBits;
      const int there = best < 0 ? -1 : used[static_cast<std::size_t>(best)];
      const bool bestFits = best >= 0 && there + bits[k] <= kWordBits;
      if (best < 0 || (fits && (!bestFits || here > there)) || (!fits && !bestFits && here < there))
        best = word;
    }
    int& filled = used[static_cast<std::size_t>(best)];
    bits[k] = std::min(bits[k], kWordBits - filled);
    if (bits[k] == 0) continue;
    places[k] = {best, filled};
    filled += bits[k];
  }
  return places;
}

}  // namespace isolux::gi
