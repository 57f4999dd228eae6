// By which arithmetic light is computed: where the processor fuses multiplication and addition, the last bits
// are others. Light of one kind is the same bit by bit on every machine that has it.
#pragma once

#include <string>

#include "volume/tracer/isosurface_tracer.h"

namespace isolux::gi {

// "fma" (AVX2, AVX-512, NEON), "no-fma" (SSE) or "scalar" (rays in volumes beyond the SIMD tracer); where
// rays are traced by another kind than directions are sampled by, both, in alphabetical order: "fma, scalar".
std::string arithmeticOf(const volume::IsosurfaceTracer& tracer);

// Of texels of both: the kinds that either names. An empty one names none.
std::string joinedArithmetic(const std::string& a, const std::string& b);

// While it lives, what is begun is computed without fused multiplication, as on a processor that has none.
// One at a time, and nothing may be computing when it comes or goes.
class NoFusedArithmetic {
 public:
  NoFusedArithmetic();
  ~NoFusedArithmetic();
  NoFusedArithmetic(const NoFusedArithmetic&) = delete;
  NoFusedArithmetic& operator=(const NoFusedArithmetic&) = delete;
};

}  // namespace isolux::gi
