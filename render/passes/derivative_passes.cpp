#include <algorithm>

#include <glm/matrix.hpp>

#include "render/gl/constants.h"
#include "render/passes/label_pass.h"
#include "render/passes/pass_declarations.h"
#include "render/passes/passes.h"
#include "render/passes/second_volume_pass.h"
#include "scene/rules/needs.h"
#include "volume/edge/surface_edges.h"
#include "volume/field/curvature.h"

namespace isolux::render {

namespace {

bool readsDirection(const FrameRequest& request) {
  return request.asksFor(Aov::direction1) || request.asksFor(Aov::direction2);
}

bool readsFlowline(const scene::Scene& scene, const FrameRequest& request) {
  return scene::needsFlowline(scene) || request.asksFor(Aov::flowline_curvature);
}

bool hessianIsRead(const Asked& asked) {
  FrameRequest request = asked.request;
  request.color = request.color && asked.volume.crossed;  // no colour of nothing
  return readsHessian(asked.scene, request);
}

// At that scale, by shaders. `hessian`: into the images of the Hessian, too, which the target's framebuffer
// then has.
void drawDerivatives(FrameState& frame, Target& target, double scaleMm, bool hessian) {
  const FieldAt field{frame.scene->derivatives.field, scaleMm};
  // In bricks, what was drawn in an earlier round of the frame stays.
  if (frame.empty() || frame.isOfLabels() || (frame.bricks() && !frame.keepHits))
    frame.clear(target, {kZero});
  if (frame.empty()) return;
  std::string defines = frame.volumeDefines() + (hessian ? "#define HESSIAN\n" : "");
  if (scaleMm > 0.0)
    defines += "#define SCALED\n";
  else if (field.field != scene::Field::trilinear)
    defines += "#define CUBIC\n";
  if (frame.scene->derivatives.fetch == scene::Fetch::fast) defines += "#define FAST\n";
  Program& p = frame.program("derivatives.frag.glsl", defines);
  frame.setView(p);
  const glm::dmat3 linear(frame.volume->grid().geometry().worldFromVoxel);
  p.set("uInverseTransposed", glm::mat3(glm::transpose(glm::inverse(linear))));
  p.set("uDataUnits", static_cast<float>(frame.volume->dataUnitsPerTexel()));
  frame.forVolumes([&] {
    frame.volume->bind(p, field);
    p.setTexture("uSurface", 2, frame.image(image::surface));
    frame.setVolumeHits(p, 3);
    frame.drawHits(target, p);
  });
}

void declareGradient(Declaring& d) {
  d.reads(image::surface).volume().settings({"derivatives.field", "derivatives.normal_scale"});
  if (scene::normalScale(d.asked.scene) == 0.0) d.settings({"derivatives.fetch"});
  d.input("executor at the hits", d.asked.onProcessor.all);
  if (sharesGradient(d.asked.scene) && hessianIsRead(d.asked))
    d.writes("gradients alone").notNeeded("the hessian pass writes gradients too");
  else
    d.writes(image::gradient, 16);
}

void drawGradient(FrameState& frame) {
  const double scaleMm = scene::normalScale(*frame.scene);
  const FieldAt field{frame.scene->derivatives.field, scaleMm};
  if (frame.gradientInStrips) return deriveOnProcessor(frame, nullptr, field, false);
  Target& target = frame.target(image::gradient, {GL_RGBA32F});
  if (frame.onProcessor.all)
    deriveOnProcessor(frame, &target, field, false);
  else
    drawDerivatives(frame, target, scaleMm, false);
}

void declareHessian(Declaring& d) {
  // The processor's Hessians stay in memory (HostImages).
  d.reads(image::surface).writes(image::hessian, d.asked.onProcessor.all ? 0 : 32);
  d.writes(image::tangents, 16);
  if (sharesGradient(d.asked.scene) && hessianIsRead(d.asked)) d.writesAs(image::gradient);
  d.volume().settings({"derivatives.field", "derivatives.scale"});
  if (scene::derivativesScale(d.asked.scene) == 0.0) d.settings({"derivatives.fetch"});
  d.input("executor at the hits", d.asked.onProcessor.all);
}

void drawHessian(FrameState& frame) {
  Target& target = frame.target(image::tangents, {GL_RGBA32F});
  const double scaleMm = scene::derivativesScale(*frame.scene);
  if (frame.onProcessor.all) {
    frame.images.drop(image::hessian + frame.layer);
    deriveOnProcessor(frame, &target, {frame.scene->derivatives.field, scaleMm}, true);
    return;
  }
  Target& hessian = frame.target(image::hessian, {GL_RGBA32F, GL_RGBA32F});
  target.framebuffer = Framebuffer(frame.gl, {&target.images[0], &hessian.images[0], &hessian.images[1]});
  target.drawn.add(hessian.drawn);
  drawDerivatives(frame, target, scaleMm, true);
  hessian.drawn = target.drawn;
  // A framebuffer would hold the memory of freed images.
  target.framebuffer = Framebuffer(frame.gl, {&target.images[0]});
}

std::size_t bytesOfHessian(const FrameState& frame) {
  return frame.images.bytesOf(image::tangents) + frame.images.bytesOf(image::hessian);
}

void declareCurvature(Declaring& d) {
  const bool asImage = readsDirection(d.asked.request);
  d.reads(image::surface).reads(image::tangents).reads(image::hessian);
  const bool flowline = readsFlowline(d.asked.scene, d.asked.request);
  d.writes(image::curvature, (asImage ? 32 : 24) + (flowline ? 4 : 0));
  d.input("directions as an image", asImage).input("flowlines", flowline);
  d.settings({"isosurface.inside", "derivatives.noise"});
}

void drawCurvature(FrameState& frame) {
  // For pictures, half floats are enough for directions.
  const GLenum direction = readsDirection(frame.request) ? GL_RGBA32F : GL_RGBA16F;
  const bool flowline = readsFlowline(*frame.scene, frame.request);
  Target& target = flowline ? frame.target(image::curvature, {GL_RGBA32F, direction, GL_R32F})
                            : frame.target(image::curvature, {GL_RGBA32F, direction});
  if (frame.clearIfEmpty(target, {kZero})) return;
  const FieldAt field = frame.curvatureField();
  std::string defines = field.scaleMm > 0.0 ? "#define SCALED\n" : "";
  if (flowline) defines += "#define FLOWLINE\n";
  Program& p = frame.program("curvature.frag.glsl", defines);
  p.setTexture("uGradient", 0, frame.image(image::tangents));
  p.set("uOutward", static_cast<float>(frame.outward()));
  const volume::GridGeometry& geometry = frame.volume->grid().geometry();
  if (field.scaleMm > 0.0) {
    p.setTexture("uSurface", 3, frame.image(image::surface));
    p.set("uScale", glm::vec3(volume::deviationsInVoxels(geometry, field.scaleMm)));
    p.set("uDims", geometry.dims);
  }
  const volume::CurvatureScale scale = volume::curvatureScale(
      geometry, field.field, *frame.scene->derivatives.noise, frame.volume->noiseBlur(), field.scaleMm);
  p.set("uGradientNoise", static_cast<float>(scale.gradientNoise));
  p.set("uFlat", static_cast<float>(scale.flatCurvature));
  p.set("uHessianNoise", static_cast<float>(scale.hessianNoise));
  p.set("uHessianRow", 0);
  if (frame.onProcessor.all) return drawFromHostHessians(frame, target, p);
  p.setTexture("uHessianDiagonal", 1, frame.image(image::hessian, 0));
  p.setTexture("uHessianMixed", 2, frame.image(image::hessian, 1));
  frame.drawHits(target, p);
}

void declareEdge(Declaring& d) {
  d.reads(image::surface).writes(image::edge, 8).volume();
  d.settings({"derivatives.field", "derivatives.scale", "derivatives.noise", "isosurface.inside", "edge."});
  d.input("executor at the hits", d.asked.onProcessor.all);
}

void drawEdge(FrameState& frame) {
  Target& target = frame.target(image::edge, {GL_RG32F});
  const float none[4] = {kNoEdge, 0.0f, 0.0f, 0.0f};
  if (frame.clearIfEmpty(target, {none})) return;
  if (frame.isOfLabels()) frame.clear(target, {none});
  const FieldAt field = frame.edgeField();
  const volume::EdgeSearch<double> search = frame.edgeSearch();
  if (frame.onProcessor.all) {
    edgesOnProcessor(frame, target, field, volume::inFloats(search));
    return;
  }
  if (frame.volume->bricks() != nullptr) {
    edgesAtReadPoints(frame, target, field, volume::inFloats(search));
    return;
  }
  const volume::Grid& grid = frame.volume->grid();
  std::string defines = frame.volumeDefines() + (field.scaleMm > 0.0 ? "#define SCALED\n" : "");
  if (grid.missingCount() > 0) defines += "#define GAPS\n";
  Program& p = frame.program("edge.frag.glsl", defines);
  frame.setView(p);
  p.set("uLow", glm::vec3(search.low));
  p.set("uHigh", glm::vec3(search.high));
  p.set("uVoxelFromWorld", glm::mat3(search.voxelFromWorld));
  p.set("uSmoothing", glm::mat3(search.smoothing));
  p.set("uNoise", glm::mat3(search.noise));
  p.set("uUnit", static_cast<float>(search.unit * frame.volume->dataUnitsPerTexel() / grid.slope()));
  p.set("uOutward", static_cast<float>(search.outward));
  p.set("uSearch", static_cast<float>(search.searchMm));
  p.set("uContrast", static_cast<float>(search.contrast));
  p.set("uLeastStep", static_cast<float>(search.leastStepMm));
  frame.forVolumes([&] {
    frame.volume->bind(p, field);
    p.setTexture("uSurface", 2, frame.image(image::surface));
    frame.setVolumeHits(p, 3);
    frame.drawHits(target, p);
  });
}

}  // namespace

PassList derivativePasses() {
  const Pass::Kind ofCrossing{.ofCrossing = true}, atHits{.atHits = true, .ofCrossing = true};
  const LookInput edge{image::edge, "EDGE", {"uEdge"}, scene::needsEdge},
      curvature{image::curvature, "CURVATURE", {"uKappa", "uDirection", "uFlowline"}, scene::needsCurvature};
  return {
      // Computes the world gradient for normals at the surface point, at derivatives.normal_scale.
      {pass::gradient, declareGradient, drawGradient, {}, atHits, Pass::Cpu::all},
      // Computes the world gradient and Hessian from the same samples, at derivatives.scale. Runs if second
      // derivatives are read, and replaces the gradient pass if both scales are equal.
      {pass::hessian, declareHessian, drawHessian, {}, atHits, Pass::Cpu::all, bytesOfHessian},
      // Computes principal curvatures, first direction and confidence.
      {"curvature", declareCurvature, drawCurvature, curvature, ofCrossing},
      // Computes the distance of the object's edge from the surface point along the outward normal, and the
      // ratio of the gradient there to its noise.
      {"edge", declareEdge, drawEdge, edge, ofCrossing, Pass::Cpu::all},
      secondVolumePass(),
      labelPass(),
      piecePass(),
      rangesPass(),
  };
}

}  // namespace isolux::render
