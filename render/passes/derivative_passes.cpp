#include "render/passes/derivative_passes.h"

#include <algorithm>

#include <glm/matrix.hpp>

#include "render/graph/pass_declarations.h"
#include "scene/rules/needs.h"
#include "volume/field/curvature.h"

namespace isolux::render {

namespace {

// Second derivatives are read: by the look, where there is a surface, or by a deferred image.
bool hessianIsRead(const Asked& asked) {
  const std::vector<Aov>& images = asked.request.aovs;
  return (asked.request.color && asked.volume.crossed && scene::needsCurvature(asked.scene)) ||
         std::any_of(images.begin(), images.end(), readsHessian);
}

void clearAll(FrameState& frame, Target& target) {
  if (target.images.size() == 1)
    frame.clear(target, {kZero});
  else
    frame.clear(target, {kZero, kZero, kZero});
}

void drawDerivatives(FrameState& frame, Target& target, const char* shader, bool hessian) {
  if (frame.onProcessor.all) {
    deriveOnProcessor(frame, target);
    return;
  }
  // In bricks, what was drawn in an earlier round of the frame stays.
  if (frame.empty() || (frame.bricks() && !frame.keepHits)) clearAll(frame, target);
  if (frame.empty()) return;
  const scene::Derivatives& settings = frame.scene->derivatives;
  std::string defines = hessian ? "#define HESSIAN\n" : "";
  if (settings.field != scene::Field::trilinear) defines += "#define CUBIC\n";
  if (settings.fetch == scene::Fetch::fast) defines += "#define FAST\n";
  Program& p = frame.program(shader, defines);
  frame.setView(p);
  frame.volume->bind(p, settings.field);
  p.setTexture("uSurface", 2, frame.image(image::surface));
  const glm::dmat3 linear(frame.volume->grid().geometry().worldFromVoxel);
  p.set("uInverseTransposed", glm::mat3(glm::transpose(glm::inverse(linear))));
  p.set("uDataUnits", static_cast<float>(frame.volume->dataUnitsPerTexel()));
  frame.drawHits(target, p);
}

}  // namespace

void GradientPass::declare(Declaring& d) const {
  d.reads(image::surface).volume().settings({"derivatives.field", "derivatives.fetch"});
  d.input("executor at the hits", d.asked.onProcessor.all);
  if (hessianIsRead(d.asked))
    d.writes("gradients alone").notNeeded("the hessian pass writes gradients too");
  else
    d.writes(image::gradient);
}

std::optional<LookInput> GradientPass::forLook(const scene::Scene& scene) const {
  if (!scene::needsGradient(scene)) return std::nullopt;
  return LookInput{image::gradient};  // FrameState::setPoint() binds them
}

void GradientPass::run(FrameState& frame) {
  drawDerivatives(frame, frame.target(image::gradient, {GL_RGBA32F}), shader, false);
}

void HessianPass::declare(Declaring& d) const {
  d.reads(image::surface).writes(image::hessian);
  d.volume().settings({"derivatives.field", "derivatives.fetch"});
  d.input("executor at the hits", d.asked.onProcessor.all);
  if (hessianIsRead(d.asked)) d.writes(image::gradient);
}

void HessianPass::run(FrameState& frame) {
  drawDerivatives(frame, frame.target(image::hessian, {GL_RGBA32F, GL_RGBA32F, GL_RGBA32F}), shader, true);
}

std::optional<std::size_t> HessianPass::bytes(const FrameState& frame) const {
  return frame.images.bytesOf(image::hessian);  // the gradients are its first image
}

void CurvaturePass::declare(Declaring& d) const {
  d.reads(image::gradient).reads(image::hessian).writes(image::curvature);
  d.settings({"isosurface.inside", "derivatives.noise"});
}

std::optional<LookInput> CurvaturePass::forLook(const scene::Scene& scene) const {
  if (!scene::needsCurvature(scene)) return std::nullopt;
  return LookInput{image::curvature, "CURVATURE", {"uKappa", "uDirection"}};
}

void CurvaturePass::run(FrameState& frame) {
  Target& target = frame.target(image::curvature, {GL_RGBA32F, GL_RGBA32F});
  if (frame.empty()) {
    frame.clear(target, {kZero, kZero});
    return;
  }
  Program& p = frame.program(shader);
  p.setTexture("uGradient", 0, frame.image(image::hessian, 0));
  p.setTexture("uHessianDiagonal", 1, frame.image(image::hessian, 1));
  p.setTexture("uHessianMixed", 2, frame.image(image::hessian, 2));
  p.set("uOutward", static_cast<float>(frame.outward()));
  const volume::CurvatureScale scale = volume::curvatureScale(
      frame.volume->grid().geometry(), frame.scene->derivatives.field, *frame.scene->derivatives.noise,
      frame.volume->facts().noise.correlation);
  p.set("uGradientNoise", static_cast<float>(scale.gradientNoise));
  p.set("uFlat", static_cast<float>(scale.flatCurvature));
  p.set("uHessianNoise", static_cast<float>(scale.hessianNoise));
  frame.drawHits(target, p);
}

}  // namespace isolux::render
