// Lists the renderer's passes, and declares those of a frame: a pure function from the request to the
// required computations. No GL.
#pragma once

#include "render/graph/pass.h"

namespace isolux::render {

// Returns the renderer's passes in the order in which they run: each after those whose images it reads.
PassList makePasses();

// Returns one declaration for each pass of the list, in its order.
std::vector<PassDeclaration> declarePasses(const PassList& passes, const Asked& asked);
// Declares the passes of the renderer's list.
std::vector<PassDeclaration> declarePasses(const scene::Scene& scene, const FrameRequest& request,
                                           const VolumeState& volume, const BrickState& bricks = {},
                                           const LightState& light = {});
// Returns the images that a request finally reads. An opaque scene has no layers pass: shade writes its
// colour.
std::vector<std::string> wantedImages(const FrameRequest& request, const scene::Scene& scene);
// Returns whether a value of the second volume is shown.
bool readsSecond(const scene::Scene& scene, const FrameRequest& request);
// Return whether the frame reads first derivatives, second derivatives or edges, through its look or one of
// its AOVs.
bool readsDerivatives(const scene::Scene& scene, const FrameRequest& request);
bool readsHessian(const scene::Scene& scene, const FrameRequest& request);
bool readsEdge(const scene::Scene& scene, const FrameRequest& request);
// Returns whether curvature and normals use derivatives at one scale: the hessian pass then writes the
// gradients of both.
bool sharesGradient(const scene::Scene& scene);

}  // namespace isolux::render
