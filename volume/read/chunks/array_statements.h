// What a file says of an array beside its numbers, in one shape for all formats: axes, units, scaling,
// numbers that stand for missing voxels.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/read/chunks/array_volume.h"

namespace isolux::volume {

// Entry i of an axis lies at first + i * step, in `unit`.
struct AxisStatement {
  std::string name;            // as axesNamed() knows it; "": none
  std::string unit;            // of `first` and `step`, by its name; "": none
  std::optional<double> step;  // none: the file does not say
  double first = 0.0;          // 0 without a step
  double deviation = 0.0;      // of stated positions from first + i * step, at most, in steps
  glm::dvec3 direction{0.0, 0.0,
                       0.0};  // unit vector in the world of rising positions; 0: the world's own axis
};

// Step, first position and deviation of the positions of all entries; no step for fewer than two of them or
// any that is not finite.
void setPositions(AxisStatement& axis, std::span<const double> positions);

// Stored numbers that are no values: these, and those outside [least, greatest].
struct MissingNumbers {
  std::vector<double> values;
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();

  bool any() const { return !values.empty() || std::isfinite(least) || std::isfinite(greatest); }
};

// value = slope * stored + intercept, with numbers of their own for each place on the first `axes` axes, in
// the order of C arrays; none where these are empty.
struct SliceScaling {
  std::uint64_t axes = 0;
  std::vector<double> slopes, intercepts;
};

struct ArrayStatements {
  std::vector<AxisStatement> axes;  // of each axis of the array; or empty
  glm::dvec3 originMm{0.0};         // added to the positions of the axes
  bool anatomical = false;          // the world is LPS by the file's own word
  double slope = 1.0, intercept = 0.0;
  std::string unit;  // of values
  MissingNumbers missing;
  SliceScaling slices;
  std::vector<std::string> warnings;  // one line each
};

// Names of the axes, "" for those without one.
std::vector<std::string> namesOf(const std::vector<AxisStatement>& axes);

// Geometry, unit, scaling and warnings of `facts`, whose first level is the array. Throws base::Error{input}
// for lengths that no volume has; `facts.name` names the file.
void applyStatements(const ArrayStatements& statements, const ArrayAxes& axes,
                     const std::vector<std::uint64_t>& dims, ChunkedFacts& facts);

// The array with missing numbers as NaN and slices scaled, as floats; itself where nothing is to be done.
std::shared_ptr<const ChunkedArray> valuesOf(std::shared_ptr<const ChunkedArray> array,
                                             const ArrayStatements& statements);

}  // namespace isolux::volume
