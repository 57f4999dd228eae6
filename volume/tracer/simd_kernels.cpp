// Chooses among the kernels that are compiled.
#include <hwy/targets.h>

#include "volume/simd_sets.h"
#include "volume/tracer/kernels.h"

namespace isolux::volume::tracing {

#define ISOLUX_TRACER_SETS(X) ISOLUX_SIMD_SETS(X) X(SCALAR)

#define ISOLUX_DECLARE(set)        \
  namespace N_##set {              \
    extern const Kernels kKernels; \
  }
ISOLUX_TRACER_SETS(ISOLUX_DECLARE)
#undef ISOLUX_DECLARE

const Kernels* kernelsOf(TracerTarget target) {
  const std::int64_t supported = hwy::SupportedTargets() | HWY_SCALAR;
#define ISOLUX_CHOOSE(one)                                                                           \
  if (const SimdSet& set = N_##one::kKernels.set;                                                    \
      (supported & set.highway) != 0 && (target == set.target || target == TracerTarget::automatic)) \
    return &N_##one::kKernels;
  ISOLUX_TRACER_SETS(ISOLUX_CHOOSE)
#undef ISOLUX_CHOOSE
  return nullptr;
}

}  // namespace isolux::volume::tracing
