// Names the instruction sets that kernels are compiled for.
#pragma once

#include <cstdint>

namespace isolux::volume {

// scalar: one lane, on any processor; only of the tracer.
enum class TracerTarget { automatic, scalar, sse4, avx2, avx512, neon };

namespace tracing {

struct SimdSet {
  TracerTarget target;
  const char* name;
  std::int64_t highway;  // HWY_AVX2, ...
};

}  // namespace tracing

}  // namespace isolux::volume
