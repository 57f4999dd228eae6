// The passes of a picture, declared: a pure function from what is asked to what must be computed. No GL.
#pragma once

#include "render/graph/pass.h"

namespace isolux::render {

// One declaration for each pass of the list, in its order.
std::vector<PassDeclaration> declarePasses(const PassList& passes, const Asked& asked);
// Of the renderer's list.
std::vector<PassDeclaration> declarePasses(const scene::Scene& scene, const FrameRequest& request,
                                           const VolumeState& volume, const BrickState& bricks = {},
                                           const LightState& light = {});
// The images a request reads in the end. An opaque picture has no layers pass: shade writes its colour.
std::vector<std::string> wantedImages(const FrameRequest& request, const scene::Scene& scene);
// The deferred image comes from second derivatives.
bool readsHessian(Aov aov);
// The picture does, by its look or one of its images.
bool readsHessian(const scene::Scene& scene, const FrameRequest& request);

}  // namespace isolux::render
