// What settings cost, as counts of work instead of times: the same on every machine, and monotone in each
// quality setting.
//
// The unit is an exact trilinear hit by a shader. The constants are ratios of passes that `isolux study` and
// `isolux_bench render` measured in software OpenGL (docs/explanation/accuracy.md,
// docs/records/2026-11-benchmarks.md), once for shaders and once for the processor; what only shaders can do
// costs the same for both.
#pragma once

#include "scene/scene.h"

namespace isolux::app {

// A ray's hit. `processor`: it computes what it can.
double hitWork(const scene::Hit& hit, bool processor);
// The derivatives of a pixel: gradients, and where `second` Hessians.
double derivativeWork(const scene::Derivatives& derivatives, bool second, bool processor);
// Stored light of a pixel's texels.
double lightWork(const scene::Gi& gi);

}  // namespace isolux::app
