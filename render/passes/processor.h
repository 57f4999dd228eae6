// Computes passes on the CPU instead of in shaders (scene::Executor), for the settings that allow it, and
// uploads the results as images for other passes.
//
// Each crossing has arrays of its own for points and their data, gradients, Hessians and shadows. The passes
// cast, gradient, hessian and shadow fill them (volume/cast) and upload them as the images that their shaders
// would draw.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "base/memory_budget.h"
#include "render/gl/image_pool.h"
#include "render/graph/pass.h"
#include "render/volume/gpu_volume.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/cast/surface_caster.h"
#include "volume/edge/edge_walk.h"

namespace isolux::render {

struct Gl;

// Returns which passes run on the CPU. `taken`: the CPU is the executor.
OnProcessor onProcessor(bool taken, const scene::Scene& scene);

// Returns whether the CPU is the executor, from the setting, the kind of context and the machine's
// capabilities.
bool takesProcessor(scene::Executor executor, const Gl& gl);

// The images of one crossing in memory, bottom row first.
struct HostImages {
  // Throws base::Error{memory}.
  explicit HostImages(glm::ivec2 size);
  struct Derivatives {
    base::MemoryBudget::Held held;
    std::vector<glm::vec4> texels;
    volume::PictureArea area;  // all are 0 outside
  };
  base::MemoryBudget::Held held;
  volume::CrossingImage crossings;
  Derivatives gradient;    // for normals, if no Hessian provides it
  Derivatives hessian[3];  // gradient; diagonal and mixed second derivatives
  volume::ShadowImage shadow;
  // Offsets and strengths of edges; outside the area none and 0.
  std::vector<glm::vec2> edges;
  volume::PictureArea edgesArea;
};

// Finds the crossings of frame.layer, or those behind frame.layerBefore, and uploads them unless they are to
// be merged. Sets frame.hitPart if no later frame reads the images.
void castOnProcessor(FrameState& frame);
// Takes the nearest of the crossings that several groups of surfaces have, and uploads it.
void mergeOnProcessor(FrameState& frame);
// Computes gradients at the points of frame.layer and uploads them to `target`, if there is one. `hessian`:
// Hessians, too, which stay in HostImages.
void deriveOnProcessor(FrameState& frame, Target* target, const FieldAt& field, bool hessian);
// Uploads rows of the gradients for normals to uGradient, on that unit (FrameState::gradientInStrips).
void setGradientStrip(FrameState& frame, Program& program, int unit, int firstRow, int rows);
// Draws as FrameState::drawHits(), with strips of the Hessians of HostImages as uHessianDiagonal and
// uHessianMixed on the units 1 and 2, and their first row as uHessianRow.
void drawFromHostHessians(FrameState& frame, Target& target, Program& program);
// Frees what HostImages hold of an image that no later pass reads.
void releaseHostImages(FrameState& frame, const std::string& image);

// Finds the object's edge at those points.
void edgesOnProcessor(FrameState& frame, Target& target, const FieldAt& field,
                      const volume::EdgeSearch<float>& search);
// As edgesOnProcessor(), at points that shaders have found, read back: the search for an edge may cross
// bricks that are not resident.
void edgesAtReadPoints(FrameState& frame, Target& target, const FieldAt& field,
                       const volume::EdgeSearch<float>& search);

// Computes whether the key light reaches those points.
void shadowOnProcessor(FrameState& frame, Target& target);

}  // namespace isolux::render
