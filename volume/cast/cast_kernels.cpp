#include "volume/cast/cast_kernels.h"

#include <hwy/targets.h>

#include "volume/edge/edge_walk.h"
#include "volume/simd_sets.h"

namespace isolux::volume {

#define ISOLUX_DECLARE(set)                         \
  namespace tracing::N_##set {                      \
    extern const casting::CastKernels kCastKernels; \
  }
ISOLUX_SIMD_SETS(ISOLUX_DECLARE)
#undef ISOLUX_DECLARE

namespace casting {

const CastKernels* castKernels(TracerTarget target) {
  const std::int64_t supported = hwy::SupportedTargets();
#define ISOLUX_CHOOSE(one)                                                                           \
  if (const tracing::SimdSet& set = tracing::N_##one::kCastKernels.set;                              \
      (supported & set.highway) != 0 && (target == set.target || target == TracerTarget::automatic)) \
    return &tracing::N_##one::kCastKernels;
  ISOLUX_SIMD_SETS(ISOLUX_CHOOSE)
#undef ISOLUX_CHOOSE
  return nullptr;
}

FoundEdge<float> edgeAt(const EdgeSearch<float>& search, const EdgeSampler& sampler, const glm::vec3& voxel) {
  return findEdge(search, sampler, voxel);
}

}  // namespace casting
}  // namespace isolux::volume
