#include "render/passes/derivative_passes.h"

#include <glm/matrix.hpp>

#include "volume/field/curvature.h"

namespace isolux::render {

namespace {
constexpr float kZero[4] = {0.0f, 0.0f, 0.0f, 0.0f};
}

void DerivativePasses::derivatives(FrameState& frame, bool hessian) {
  const Target& target = hessian ? frame.target(pass::hessian, {GL_RGBA32F, GL_RGBA32F, GL_RGBA32F})
                                 : frame.target(pass::gradient, {GL_RGBA32F});
  frame.begin(target);
  for (std::size_t i = 0; i < target.images.size() && !frame.keepHits; ++i)
    frame.clear(target, static_cast<int>(i), kZero);
  if (frame.empty()) return;
  const scene::Derivatives& settings = frame.scene->derivatives;
  std::string defines = hessian ? "#define HESSIAN\n" : "";
  if (settings.field != scene::Field::trilinear) defines += "#define CUBIC\n";
  if (settings.fetch == scene::Fetch::fast) defines += "#define FAST\n";
  Program& p = frame.program("derivatives.frag.glsl", defines);
  frame.setView(p);
  frame.volume->bind(p, settings.field);
  p.setTexture("uSurface", 2, frame.image(pass::refine));
  const glm::dmat3 linear(frame.volume->grid().geometry().worldFromVoxel);
  p.set("uInverseTransposed", glm::mat3(glm::transpose(glm::inverse(linear))));
  p.set("uDataUnits", static_cast<float>(frame.volume->dataUnitsPerTexel()));
  frame.drawFullscreen(p);
}

void DerivativePasses::curvature(FrameState& frame) {
  const Target& target = frame.target(pass::curvature, {GL_RGBA32F, GL_RGBA32F});
  frame.begin(target);
  frame.clear(target, 0, kZero);
  frame.clear(target, 1, kZero);
  if (frame.empty()) return;
  Program& p = frame.program("curvature.frag.glsl");
  p.setTexture("uGradient", 0, frame.image(pass::hessian, 0));
  p.setTexture("uHessianDiagonal", 1, frame.image(pass::hessian, 1));
  p.setTexture("uHessianMixed", 2, frame.image(pass::hessian, 2));
  p.set("uOutward", static_cast<float>(frame.outward()));
  const volume::CurvatureScale scale = volume::curvatureScale(
      frame.volume->grid().geometry(), frame.scene->derivatives.field, *frame.scene->derivatives.noise);
  p.set("uGradientNoise", static_cast<float>(scale.gradientNoise));
  p.set("uFlat", static_cast<float>(scale.flatCurvature));
  p.set("uHessianNoise", static_cast<float>(scale.hessianNoise));
  frame.drawFullscreen(p);
}

}  // namespace isolux::render
