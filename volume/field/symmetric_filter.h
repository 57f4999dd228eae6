// Convolution of lines of samples with a symmetric kernel: for filterLines().
#pragma once

#include <vector>

#include "volume/field/filter_lines.h"
#include "volume/field/scale_kernel.h"

namespace isolux::volume {

// What stands beyond the border of a line: its point reflections, f(-k) = 2 f(0) - f(k), which go on with a
// ramp and keep the border samples; or zeros.
enum class Beyond { reflected, nothing };

// A sample of an axis, and the factor by which it contributes.
struct ReflectedSample {
  int at;
  double factor;
};
// Returns the contributions to sample k of an axis of n samples: itself, or, beyond the border, the sum that
// point reflections make. An axis of one sample is constant.
std::vector<ReflectedSample> reflectedSample(int k, int n);

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
