// Declares the passes, and what they share with each other. render/passes/pass_declarations.cpp lists them in
// their order.
#pragma once

#include "render/passes/frame_state.h"
#include "render/passes/gloss_passes.h"

namespace isolux::render {

// ---- Hits: surface points on rays

// Finds the active blocks of the isovalues, and which of their sub-blocks can contain a surface.
class BlocksPass : public Pass {
 public:
  BlocksPass() : Pass("blocks", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Finds the depths between which the rays of each tile can meet anything, by projecting the active blocks.
class SegmentsPass : public Pass {
 public:
  SegmentsPass() : Pass("segments", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Uploads the bricks that the rays of the previous frame requested; does nothing for a volume in one texture.
class BricksPass : public Pass {
 public:
  BricksPass() : Pass(pass::bricks, "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Finds the first crossing of an isovalue on each ray: exact hits are the surface points, sampled ones still
// a bracket [t0, t1]. In a layer, finds the crossing behind that of the previous layer; pixels without one
// are unchanged.
class CastPass : public Pass {
 public:
  CastPass() : Pass(pass::cast, "cast.frag.glsl", {.castsRays = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.casts; }

 private:
  enum class Rays { all, again, behind };
  Program& program(FrameState& frame, Rays rays) const;
  void castBehind(FrameState& frame) const;
};

// Refines a sampled hit to a surface point, by narrowing its bracket on the exact field of hit.field.
class RefinePass : public Pass {
 public:
  RefinePass() : Pass(pass::refine, "refine.frag.glsl", {.atHits = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

Target& surfaceTarget(FrameState& frame);  // returns the images of image::surface, to draw into
bool anyHit(FrameState& frame);            // returns whether there is any surface point

// Return the defines for shaders that cast rays, and set the inputs of trace.glsl and trace_cubic.glsl: view,
// volume, isovalues, block masks, hidden components. Texture units 0, 1, 3, 14.
std::string traceDefines(const FrameState& frame);
void setTrace(FrameState& frame, Program& program);

// ---- Derivatives and curvature at surface points, once per pixel

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

// Determines the connected component of its isosurface that each surface point belongs to (volume/pieces).

// Writes ids as of volume::Pieces of that isosurface, 0 the largest; -1 if there is no surface. Always runs
// on the CPU. Ids are floats: those of 2^24 and more are rounded.
class PiecePass : public Pass {
 public:
  PiecePass() : Pass("piece", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor&) const override { return true; }
};

// ---- Shadow, occlusion and flow at surface points, once per pixel

// Casts a second ray from each surface point towards the key light.
class ShadowPass : public Pass {
 public:
  ShadowPass()
      : Pass("shadow", "shadow.frag.glsl", {.castsRays = true, .ofCrossing = true},
             {image::shadow, "SHADOW", {"uLit"}, scene::showsShadow}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

// Computes the fraction of directions around a surface point that nearby geometry leaves open, from the
// image's own points [Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion"].
// Works on cells of some rays each, along one line in the image, which changes from cell to cell, and
// averages over neighbours.
class OpennessPass : public Pass {
 public:
  OpennessPass() : Pass("openness", "openness.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Turns openness into occlusion. A tile contains only a part of the nearby geometry. It therefore uses its
// part of the small image drawn before the tiles.
class OcclusionPass : public Pass {
 public:
  OcclusionPass()
      : Pass("occlusion", "occlusion.frag.glsl", {.ofCrossing = true},
             {image::occlusion, "OCCLUSION", {"uOpen"}, scene::showsOcclusion}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;

 private:
  static std::string keptName(int crossing);
  void takeKept(FrameState& frame);

  int crossing_ = 0;
};

// Returns the rays per axis of a cell; 1 in the small image before tiles.
int occlusionCell(const FrameRequest& request);
// Returns the image's size in cells.
glm::ivec2 occlusionCells(const FrameRequest& request);

// Computes the direction of the flow on the screen, and noise on the surface.
class FlowFieldPass : public Pass {
 public:
  FlowFieldPass() : Pass("flow field", "flow_field.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Draws streaks along the flow field.
class FlowPass : public Pass {
 public:
  FlowPass()
      : Pass("flow", "flow.frag.glsl", {.ofCrossing = true},
             {image::flow, "FLOW", {"uFlow"}, scene::showsFlow}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// ---- Lines that follow the surface's curvature, in image space

// Computes the change of each principal curvature along its own direction: 0 on ridges and valleys.
class ExtremaPass : public Pass {
 public:
  ExtremaPass() : Pass("extrema", "extrema.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Finds the lines near each pixel: ridges and valleys, suggestive contours, outlines.
class LineFieldPass : public Pass {
 public:
  LineFieldPass() : Pass("line field", "line_field.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Computes the coverage of each pixel by lines that are long and strong enough.
class LinesPass : public Pass {
 public:
  LinesPass()
      : Pass("lines", "lines.frag.glsl", {.ofCrossing = true},
             {image::lines, "LINES", {"uLines"}, scene::drawsLines}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Returns how many pixels around one decide which lines it shows.
double reachOfLines(const scene::Scene& scene, int heightInRays);

// ---- Linear colour from surface points and their derivatives

// Computes automatic numbers from the curvature of the volume's whole surface; independent of the view.
class RangesPass : public Pass {
 public:
  RangesPass();
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Shades the first crossing in linear colour; a layer is blended behind the colour drawn so far.
class ShadePass : public Pass {
 public:
  ShadePass() : Pass(pass::shade, "shade.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  void forget() override {
    colors_ = Texture();
    secondColors_ = Texture();
    crevices_ = Texture();
    gloss_.forget();
  }

 private:
  void drawBand(FrameState& frame);
  Program& prepared(FrameState& frame);  // returns its program with all its inputs set
  void setSurfaces(FrameState& frame, Program& program) const;
  void setLight(FrameState& frame, Program& program) const;
  void setMeasure(FrameState& frame, Program& program);
  void setSecond(FrameState& frame, Program& program, int unit);
  void setCrevices(const FrameState& frame, Program& program, int unit);
  void setOverlays(FrameState& frame, Program& program) const;

  // The colour map's samples, and the look they were made from.
  Texture colors_;
  scene::Look colorsOf_;
  Texture secondColors_;  // of the second volume
  scene::ColorMap secondColorsOf_ = scene::ColorMap::automatic;
  GlossUniforms gloss_;
  Texture crevices_;  // of look.accessibility_points
  std::optional<std::vector<scene::ColorPoint>> crevicesOf_;
};

// Draws crossings behind transparent surfaces, one after another until none is visible. For each crossing,
// runs all passes from cast to shade again.
class LayersPass : public Pass {
 public:
  LayersPass() : Pass(pass::layers, "", {.castsRays = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// ---- The final image from linear colour

// Draws the pixels without a surface, if they do not depend on the view.
class BackgroundPass : public Pass {
 public:
  BackgroundPass() : Pass("background", "resolve.frag.glsl", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Adds the background, averages supersamples, encodes sRGB and adds the legend.
class ResolvePass : public Pass {
 public:
  ResolvePass() : Pass(pass::resolve, "resolve.frag.glsl", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;

 private:
  Program& prepared(FrameState& frame, const std::string& defines) const;
  void drawAll(FrameState& frame, const Target& target, const std::string& defines) const;
  void drawHits(FrameState& frame, Target& target) const;
};

}  // namespace isolux::render
