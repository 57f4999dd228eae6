// Names the floating-point arithmetic that light is computed with.
//
// If the processor fuses multiplication and addition, the last bits differ. Light of one kind of arithmetic
// is bit-identical on every machine that has it.
#pragma once

#include <string>

#include "volume/tracer/isosurface_tracer.h"

namespace isolux::gi {

// Returns "fma" (AVX2, AVX-512, NEON), "no-fma" (SSE) or "scalar" (rays in volumes beyond the SIMD tracer).
// If rays are traced by another kind than directions are sampled by, returns both in alphabetical order:
// "fma, scalar".
std::string arithmeticOf(const volume::IsosurfaceTracer& tracer);

// Returns the union of the kinds that `a` and `b` name, for texels of both. An empty string names none.
std::string joinedArithmetic(const std::string& a, const std::string& b);

// Disables fused multiplication for computations started during its lifetime, as on a processor without it.
// Requires that only one exists at a time, and that nothing is being computed when it is created or
// destroyed.
class NoFusedArithmetic {
 public:
  NoFusedArithmetic();
  ~NoFusedArithmetic();
  NoFusedArithmetic(const NoFusedArithmetic&) = delete;
  NoFusedArithmetic& operator=(const NoFusedArithmetic&) = delete;
};

}  // namespace isolux::gi
