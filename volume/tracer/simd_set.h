// Instruction sets that kernels are compiled for.
#pragma once

#include <cstdint>

#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume::tracing {

struct SimdSet {
  TracerTarget target;
  const char* name;
  std::int64_t highway;  // HWY_AVX2, ...
};

}  // namespace isolux::volume::tracing
