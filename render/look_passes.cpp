#include "render/look_passes.h"

#include <glm/geometric.hpp>

namespace isolux::render {

namespace {

constexpr float kZero[4] = {0.0f, 0.0f, 0.0f, 0.0f};

glm::vec3 towardLight(const FrameState& frame) {
  const ViewUniforms& view = *frame.view;
  const glm::dvec3 given = frame.scene->light.direction;
  const glm::dvec3 d = glm::length(given) > 0.0 ? glm::normalize(given) : glm::dvec3(0.0, 0.0, 1.0);
  return d.x * view.rightWorld + d.y * view.upWorld - d.z * view.forwardWorld;
}

}  // namespace

void LookPasses::drawShading(FrameState& frame) {
  const scene::Look& look = frame.scene->look;
  Program& p =
      frame.program("shade.frag.glsl", "#define LOOK " + std::to_string(static_cast<int>(look.mode)) + "\n");
  frame.setView(p);
  p.setTexture("uSurface", 0, frame.image(pass::refine, 0));
  p.setTexture("uInfo", 1, frame.image(pass::refine, 1));
  if (needsOf(*frame.scene).gradient) p.setTexture("uGradient", 2, frame.gradientImage());
  p.set("uRightWorld", glm::vec3(frame.view->rightWorld));
  p.set("uUpWorld", glm::vec3(frame.view->upWorld));
  p.set("uForwardWorld", glm::vec3(frame.view->forwardWorld));
  p.set("uOutward", static_cast<float>(frame.outward()));
  glm::vec4 opacities(1.0f);
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i) {
    const std::string name = "uAlbedos[" + std::to_string(i) + "]";
    p.set(name.c_str(), glm::vec3(frame.surfaces[i].albedo));
    opacities[static_cast<int>(i)] = static_cast<float>(frame.surfaces[i].opacity);
  }
  p.set("uOpacities", opacities);
  p.set("uAmbient", static_cast<float>(look.ambient));
  p.set("uSpecular", static_cast<float>(look.specular));
  p.set("uShininess", static_cast<float>(look.shininess));
  p.set("uIntensity", static_cast<float>(frame.scene->light.intensity));
  p.set("uLight", towardLight(frame));
  p.set("uDepthRange", glm::vec2(frame.view->depthRangeMm));
  frame.drawFullscreen(p);
}

void LookPasses::shade(FrameState& frame) {
  const Target& target = frame.target(pass::shade, {GL_RGBA16F});
  frame.begin(target);
  if (frame.empty())
    frame.clear(target, 0, kZero);
  else
    drawShading(frame);
}

void LookPasses::layers(FrameState& frame, HitPasses& hits, DerivativePasses& derivatives) {
  const Target& color = frame.target(pass::layers, {GL_RGBA16F});
  const Target& front = frame.images.at(pass::shade);
  const glm::ivec2 size = frame.raySize();
  const Gl& gl = *frame.gl;
  gl.BlitNamedFramebuffer(front.framebuffer.id(), color.framebuffer.id(), 0, 0, size.x, size.y, 0, 0, size.x,
                          size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  if (frame.empty()) return;
  // Each layer reads the surface image of the one before it: two names in turn.
  const char* const names[2] = {" of a layer", " of the next layer"};
  std::string before;
  for (int layer = 1; layer < frame.scene->isosurface.layers; ++layer) {
    frame.layer = names[layer % 2];
    if (!hits.castBehind(frame, before)) break;
    if (frame.scene->hit.method == scene::HitMethod::sampled) hits.refine(frame);
    if (frame.withHessian) {
      derivatives.hessian(frame);
      derivatives.curvature(frame);
    } else if (needsOf(*frame.scene).gradient) {
      derivatives.gradient(frame);
    }
    frame.begin(color);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);  // premultiplied, front to back
    drawShading(frame);
    gl.Disable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    before = frame.layer;
  }
  frame.layer.clear();
}

void LookPasses::resolve(FrameState& frame) {
  const Target& target = frame.images.make(frame.gl, pass::resolve, frame.request.size, {GL_RGBA8});
  frame.begin(target, frame.request.size);
  Program& p = frame.program("resolve.frag.glsl");
  p.setTexture("uColor", 0, frame.image(isTransparent(*frame.scene) ? pass::layers : pass::shade));
  p.set("uSupersampling", frame.request.supersampling);
  p.set("uBackgroundTop", glm::vec3(frame.scene->look.backgroundTop));
  p.set("uBackgroundBottom", glm::vec3(frame.scene->look.backgroundBottom));
  frame.drawFullscreen(p);
}

}  // namespace isolux::render
