#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/matrix.hpp>

#include "render/passes/curvature_ranges.h"
#include "render/passes/passes.h"
#include "scene/opacity.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

constexpr float kNoField[4] = {0.0f, 0.0f, -1.0f, 0.0f};

constexpr float kAllOpen[4] = {1.0f, -1.0f, 0.0f, 0.0f};
// Occlusion is found in cells of so many pixels per axis, or larger ones where an axis had more of them.
constexpr int kPixelsOfCell = 2, kMostCells = 1024;
// How far it is looked for in the picture, in parts of its height.
constexpr double kOcclusionReach = 0.25;

// What the area of the hits covers of the image in cells.
volume::PictureArea inCells(const FrameState& frame, glm::ivec2 cells) {
  const int cell = occlusionCell(frame.request);
  volume::PictureArea scaled(cells);
  for (const volume::Rectangle& part : frame.area().rectangles()) {
    const glm::ivec2 from = part.low + frame.raysLow();
    const glm::ivec2 low = from / cell, high = (from + part.size + cell - 1) / cell;
    for (int row = low.y; row < high.y; ++row) scaled.add(row, low.x, high.x);
  }
  return scaled;
}

// Where the pattern of the flow stands in its period, [0, 1).
double phaseOf(const scene::Flow& flow) {
  const double periods = flow.time * flow.speed;
  return periods - std::floor(periods);
}

void declareShadow(Declaring& d) {
  d.reads(image::surface).reads(image::gradient).reads(image::activeBlocks).writes(image::shadow, 1);
  d.settings({"camera.", "hit.method", "hit.field", "light.space", "light.direction"}).cuts();
  d.ofSurfaces("what is opaque", scene::isOpaque);
  d.input("executor at the hits", d.asked.onProcessor.all);
}

// Behind the first group, what others leave lit.
void drawShadowOfGroup(FrameState& frame, Target& target) {
  const Gl& gl = *frame.gl;
  Program& p = frame.program("shadow.frag.glsl", traceDefines(frame));
  setTrace(frame, p);
  frame.setPoint(p, 4);
  p.set("uVoxelFromWorld", glm::mat3(frame.volume->grid().geometry().voxelFromWorld()));
  p.set("uLight", glm::vec3(frame.towardLight()));
  p.set("uOpaqueBits", frame.opaqueBits());
  p.set("uFirst", static_cast<int>(frame.firstSurface()));
  if (frame.group == 0) return frame.drawHits(target, p);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_DST_COLOR, GL_ZERO);
  frame.drawHits(target, p);
  gl.Disable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ZERO);
}

void drawShadow(FrameState& frame) {
  Target& target = frame.target(image::shadow, {GL_R8});
  if (frame.clearIfEmpty(target, {kZero})) return;
  if (frame.onProcessor.all) return shadowOnProcessor(frame, target);
  frame.forGroups([&] {
    if (frame.group == 0 || !frame.groupIsEmpty()) drawShadowOfGroup(frame, target);
  });
}

void declareOpenness(Declaring& d) {
  d.reads(image::surface).reads(image::gradient).writes(image::openness);
  d.settings({"camera.", "isosurface.inside", "look.occlusion_radius"}).pictureSize();
}

void drawOpenness(FrameState& frame) {
  const glm::ivec2 cells = occlusionCells(frame.request);
  Target& target = frame.images.make(frame.gl, image::openness + frame.layer, cells, {GL_RGBA16F});
  if (frame.clearIfEmpty(target, {kZero})) return;
  Program& p = frame.program("openness.frag.glsl");
  frame.setView(p);
  frame.setPoint(p, 0);
  p.set("uDepthRange", glm::vec2(frame.view->depthRangeMm));
  p.set("uCell", occlusionCell(frame.request));
  p.set("uRadius", static_cast<float>(frame.scene->look.occlusionRadius.value()));
  p.set("uMostRays",
        static_cast<float>(kOcclusionReach * frame.request.size.y * frame.request.supersampling));
  const volume::PictureArea area = inCells(frame, cells);
  if (!frame.gradientInStrips) return frame.drawHits(target, p, area);
  volume::PictureArea drawn = area;
  drawn.add(target.drawn);
  const int cell = occlusionCell(frame.request), rows = std::max(frame.bandRows / cell, 1);
  frame.begin(target);
  for (int row = 0; row < cells.y && !frame.request.stop.stop_requested(); row += rows) {
    setGradientStrip(frame, p, 1, row * cell - frame.raysLow().y, rows * cell);
    frame.drawRectangles(p, volume::partsOf(drawn, {{0, row}, {cells.x, rows}}));
  }
  target.drawn = area;
}

void declareOcclusion(Declaring& d) {
  d.reads(image::surface).writes(image::occlusion).pictureSize();
  d.input("of the tiles' whole picture", d.asked.request.tile.has_value(), d.asked.request.beforeTiles);
  if (!d.asked.request.tile) d.reads(image::openness);
}

// Another name for each crossing: layers behind share two.
std::string keptName(int crossing) {
  return std::string(image::occlusion) + " of the whole picture, crossing " + std::to_string(crossing);
}

void takeKept(FrameState& frame) {
  const std::string kept = keptName(frame.occlusionCrossing), own = image::occlusion + frame.layer;
  if (!frame.images.has(kept))
    return frame.clear(frame.images.make(frame.gl, own, glm::ivec2(1), {GL_RG32F}), {kAllOpen});
  const glm::ivec2 size(frame.images.at(kept).images[0].size());
  frame.copy(frame.images.at(kept), frame.images.make(frame.gl, own, size, {GL_RG32F}));
}

void drawOcclusion(FrameState& frame) {
  int& crossing = frame.occlusionCrossing;
  crossing = frame.layer.empty() ? 0 : crossing + 1;
  if (frame.request.tile) return takeKept(frame);
  if (frame.request.beforeTiles && crossing == 0)  // those of an earlier picture
    for (int i = 0; frame.images.has(keptName(i)); ++i) frame.images.drop(keptName(i));
  const glm::ivec2 cells = occlusionCells(frame.request);
  Target& target = frame.images.make(frame.gl, image::occlusion + frame.layer, cells, {GL_RG32F});
  if (frame.empty()) {
    frame.clear(target, {kAllOpen});
  } else {
    Program& p = frame.program("occlusion.frag.glsl");
    frame.setView(p);
    p.setTexture("uOpenness", 0, frame.image(image::openness));
    p.set("uDepthRange", glm::vec2(frame.view->depthRangeMm));
    p.set("uCell", occlusionCell(frame.request));
    frame.drawHits(target, p, inCells(frame, cells));
  }
  if (frame.request.beforeTiles)
    frame.copy(target, frame.images.make(frame.gl, keptName(crossing), cells, {GL_RG32F}));
}

void declareFlowField(Declaring& d) {
  d.reads(image::surface)
      .reads(image::gradient)
      .reads(image::tangents)
      .reads(image::curvature)
      .reads(image::ranges)
      .writes(image::flowField, 24);
  d.settings({"camera.", "isosurface.inside", "flow.direction", "flow.grain"}).pictureSize();
  d.input("pixel ratio", d.asked.request.pixelRatio);
}

void drawFlowField(FrameState& frame) {
  Target& target = frame.target(image::flowField, {GL_RGBA32F, GL_RGBA16F});
  if (frame.clearIfEmpty(target, {kNoField, kZero})) return;
  const scene::Flow& flow = frame.scene->flow;
  Program& p = frame.program("flow_field.frag.glsl",
                             flow.direction == scene::FlowDirection::minimum ? "#define MINIMUM\n" : "");
  frame.setView(p);
  frame.setPoint(p, 0);
  p.setTexture("uKappa", 3, frame.image(image::curvature, 0));
  p.setTexture("uDirection", 4, frame.image(image::curvature, 1));
  p.setTexture("uCurvatureGradient", 5, frame.image(image::tangents));
  p.set("uFlat", static_cast<float>(frame.flatCurvature()));
  p.set("uGrain", static_cast<float>(flow.grain * frame.raysPerWidth()));
  p.set("uCurvatureScale", static_cast<float>(curvatureScale(frame.statistics, frame.flatCurvature())));
  frame.drawHits(target, p);
}

void declareFlow(Declaring& d) {
  d.reads(image::flowField).writes(image::flow, 2).settings({"flow.length", "flow.grain"}).pictureSize();
  d.input("pixel ratio", d.asked.request.pixelRatio);
  const bool moves = d.asked.acts("flow.time");  // flow.time and flow.speed act through the phase alone
  d.input("phase of the flow", moves ? phaseOf(d.asked.scene.flow) : 0.0);
}

void drawFlow(FrameState& frame) {
  Target& target = frame.target(image::flow, {GL_R16F});
  const scene::Flow& flow = frame.scene->flow;
  const double raysPerPixel = frame.raysPerWidth(), grain = flow.grain * raysPerPixel;
  // Steps of half a grain miss nothing; long streaks of fine grain take at most 128 a way.
  const double half = 0.5 * flow.length * raysPerPixel;
  const double step = std::max({1.0, 0.5 * grain, half / 128.0});
  Texture& noise = frame.images.at(image::flowField + frame.layer).images[1];
  noise.setFilter(GL_LINEAR);
  Program& p = frame.program("flow.frag.glsl");
  p.setTexture("uField", 0, frame.image(image::flowField, 0));
  p.setTexture("uNoise", 1, noise);
  p.set("uHalfLength", static_cast<float>(std::max(half, step)));
  p.set("uStep", static_cast<float>(step));
  p.set("uGrain", static_cast<float>(grain));
  p.set("uPhase", static_cast<float>(2.0 * std::numbers::pi * phaseOf(flow)));
  frame.drawHits(target, p);
}

}  // namespace

PassList effectPasses() {
  const Pass::Kind ofCrossing{.ofCrossing = true}, castsRays{.castsRays = true, .ofCrossing = true};
  const LookInput shadow{image::shadow, "SHADOW", {"uLit"}, scene::showsShadow},
      occlusion{image::occlusion, "OCCLUSION", {"uOpen"}, scene::showsOcclusion};
  return {
      // Casts a second ray from each surface point towards the key light.
      {pass::shadow, declareShadow, drawShadow, shadow, castsRays, Pass::Cpu::all},
      // Computes the fraction of directions around a surface point that nearby geometry leaves open, from the
      // image's own points [Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect
      // Occlusion"]. Works on cells of some rays each, along one line in the image, which changes from cell
      // to cell, and averages over neighbours.
      {pass::openness, declareOpenness, drawOpenness, {}, ofCrossing},
      // Turns openness into occlusion. A tile contains only a part of the nearby geometry. It therefore uses
      // its part of the small image drawn before the tiles.
      {"occlusion", declareOcclusion, drawOcclusion, occlusion, ofCrossing},
      // Computes the direction of the flow on the screen, and noise on the surface.
      {"flow field", declareFlowField, drawFlowField, {}, ofCrossing},
      // Draws streaks along the flow field.
      {"flow", declareFlow, drawFlow, {image::flow, "FLOW", {"uFlow"}, scene::showsFlow}, ofCrossing},
  };
}

int occlusionCell(const FrameRequest& request) {
  if (request.beforeTiles) return 1;
  const int rays = std::max(request.size.x, request.size.y) * request.supersampling;
  return std::max(kPixelsOfCell * request.supersampling, (rays + kMostCells - 1) / kMostCells);
}

glm::ivec2 occlusionCells(const FrameRequest& request) {
  const int cell = occlusionCell(request);
  return (request.size * request.supersampling + cell - 1) / cell;
}

}  // namespace isolux::render
