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
// The deferred image comes from derivatives, or tells of them; from second ones.
bool readsDerivatives(Aov aov);
bool readsHessian(Aov aov);
bool readsEdge(Aov aov);
// Some value of the second volume is shown.
bool readsSecond(const scene::Scene& scene, const FrameRequest& request);
// The picture does, by its look or one of its images.
bool readsDerivatives(const scene::Scene& scene, const FrameRequest& request);
bool readsHessian(const scene::Scene& scene, const FrameRequest& request);
bool readsEdge(const scene::Scene& scene, const FrameRequest& request);
// Curvature and normals are of derivatives at one scale: the hessian pass writes the gradients of both.
bool sharesGradient(const scene::Scene& scene);

}  // namespace isolux::render
