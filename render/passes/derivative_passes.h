// Computes derivatives and curvature at surface points, once per pixel: the passes gradient, hessian,
// curvature and edge.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Computes the world gradient for normals at the surface point, at derivatives.normal_scale.
class GradientPass : public Pass {
 public:
  GradientPass() : Pass(pass::gradient, "derivatives.frag.glsl", {.atHits = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

// Computes the world gradient and Hessian from the same samples, at derivatives.scale. Runs if second
// derivatives are read, and replaces the gradient pass if both scales are equal.
class HessianPass : public Pass {
 public:
  HessianPass() : Pass(pass::hessian, "derivatives.frag.glsl", {.atHits = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

// Computes principal curvatures, first direction and confidence.
class CurvaturePass : public Pass {
 public:
  CurvaturePass()
      : Pass("curvature", "curvature.frag.glsl", {.ofCrossing = true},
             {image::curvature, "CURVATURE", {"uKappa", "uDirection", "uFlowline"}, scene::needsCurvature}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Computes the distance of the object's edge from the surface point along the outward normal, and the ratio
// of the gradient there to its noise.
class EdgePass : public Pass {
 public:
  EdgePass()
      : Pass("edge", "edge.frag.glsl", {.ofCrossing = true},
             {image::edge, "EDGE", {"uEdge"}, scene::needsEdge}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

}  // namespace isolux::render
