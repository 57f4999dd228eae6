// What the processor computes instead of shaders (scene::Executor), for which settings, and how it comes to
// the images that other passes read.
//
// Data: points and what is known of them, gradients, Hessians and shadows of each crossing, in arrays of
// their own; the passes cast, gradient, hessian and shadow fill them (volume/cast) and upload them as the
// images that their shaders would draw.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "base/memory_budget.h"
#include "render/gl/image_pool.h"
#include "render/graph/pass.h"
#include "render/volume/gpu_volume.h"
#include "scene/machine.h"
#include "scene/scene.h"
#include "volume/cast/surface_caster.h"
#include "volume/edge/edge_walk.h"

namespace isolux::render {

struct Gl;

// taken: the processor is the executor.
OnProcessor onProcessor(bool taken, const scene::Scene& scene);

// Whether the executor is the processor: by the setting, the kind of context and what this machine can.
bool takesProcessor(scene::Executor executor, const Gl& gl);

// The images of one crossing as they lie in memory, bottom row first.
struct HostImages {
  // Throws base::Error{memory}.
  explicit HostImages(glm::ivec2 size);
  struct Derivatives {
    std::vector<glm::vec4> texels;
    volume::PictureArea area;  // beyond it all are 0
  };
  base::MemoryBudget::Held held;
  volume::CrossingImage crossings;
  Derivatives gradient;    // of normals, where no Hessian comes with it
  Derivatives hessian[3];  // gradient; diagonal and mixed
  volume::ShadowImage shadow;
  // Offsets and strengths of edges; beyond the area none and 0.
  std::vector<glm::vec2> edges;
  volume::PictureArea edgesArea;
};

// Finds the crossings of frame.layer, or those behind frame.layerBefore, and uploads them.
void castOnProcessor(FrameState& frame);
// Derivatives at the points of frame.layer, uploaded to the images of `target`: gradient; with three,
// diagonal and mixed of the Hessian too.
void deriveOnProcessor(FrameState& frame, Target& target, const FieldAt& field);

// Where the edge of the object is at those points.
void edgesOnProcessor(FrameState& frame, Target& target, const FieldAt& field,
                      const volume::EdgeSearch<float>& search);
// The same at the points that shaders have found, read back: the way to an edge leads through bricks that
// need not be there.
void edgesAtReadPoints(FrameState& frame, Target& target, const FieldAt& field,
                       const volume::EdgeSearch<float>& search);

// Whether the key light reaches those points. opaque: a bit for each surface that stops it.
void shadowOnProcessor(FrameState& frame, Target& target, int opaque);

}  // namespace isolux::render
