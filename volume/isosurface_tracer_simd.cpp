#include "volume/isosurface_tracer_kernels.h"

namespace isolux::volume::tracing {

const Kernels* simdKernels(TracerTarget) {
  return nullptr;
}

}  // namespace isolux::volume::tracing
