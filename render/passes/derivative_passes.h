// Surface points to derivatives and curvature, once per pixel: the passes gradient, hessian and curvature.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// The world gradient at the surface point that normals are made of: at derivatives.normal_scale.
class GradientPass : public Pass {
 public:
  GradientPass() : Pass(pass::gradient, "derivatives.frag.glsl", {.atHits = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

// The world gradient and Hessian from the same samples, at derivatives.scale: runs where second derivatives
// are read, and instead of the gradient pass where both scales are the same.
class HessianPass : public Pass {
 public:
  HessianPass() : Pass(pass::hessian, "derivatives.frag.glsl", {.atHits = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

// Principal curvatures, first direction, confidence.
class CurvaturePass : public Pass {
 public:
  CurvaturePass() : Pass("curvature", "curvature.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;
};

// How far the edge of the object lies from the surface point along the outward normal, and how far the
// gradient there stands out of noise.
class EdgePass : public Pass {
 public:
  EdgePass() : Pass("edge", "edge.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

}  // namespace isolux::render
