// Convolution of lines of samples with a symmetric kernel: for filterLines().
#pragma once

#include <vector>

#include "volume/field/filter_lines.h"
#include "volume/field/scale_kernel.h"

namespace isolux::volume {

// What stands beyond the border of a line: its point reflections, f(-k) = 2 f(0) - f(k), which go on with a
// ramp and keep the border samples; or zeros.
enum class Beyond { reflected, nothing };

// Calls add(sample, factor) for what contributes to sample k of an axis of n samples: itself, or, beyond the
// border, the sum that point reflections make. An axis of one sample is constant.
template <class Add>
void addReflected(int k, int n, const Add& add) {
  double sign = 1.0;
  for (; n > 1 && (k < 0 || k > n - 1); sign = -sign) {
    const int border = k < 0 ? 0 : n - 1;
    add(border, 2.0 * sign);
    k = 2 * border - k;
  }
  add(n > 1 ? k : 0, sign);
}

// Double arithmetic. A kernel of any length: reflections repeat after twice the line, where a longer kernel
// is folded.
class SymmetricFilter {
 public:
  SymmetricFilter(const HalfKernel& kernel, std::size_t length, Beyond beyond);
  void operator()(const FilterLines& lines);

 private:
  void load(const FilterLines& lines);
  void extend();
  void store(const FilterLines& lines) const;
  double* sample(std::size_t k) { return samples_.data() + (reach_ + k) * kLines; }
  const double* sample(std::size_t k) const { return samples_.data() + (reach_ + k) * kLines; }

  std::size_t length_, reach_;
  Beyond beyond_;
  HalfKernel kernel_;
  std::vector<double> samples_;        // less their ramp; sample k of line r at (reach_ + k) * kLines + r
  std::vector<double> first_, slope_;  // of the ramp from the first to the last sample of each line
};

}  // namespace isolux::volume
