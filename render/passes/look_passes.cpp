#include "render/passes/look_passes.h"

#include "render/legend/legend_overlay.h"
#include "render/passes/curvature_ranges.h"
#include "render/readback.h"
#include "scene/rules/relevance.h"

namespace isolux::render {

namespace {

// Of all layers together.
constexpr std::size_t kMostHitsBehind = 1u << 20;
constexpr float kZero[4] = {0.0f, 0.0f, 0.0f, 0.0f};

// Texture units of shade.frag.glsl.
enum Unit {
  surfaceUnit,  // surfaceUnit to infoUnit: FrameState::setPoint()
  gradientUnit,
  infoUnit,
  kappaUnit,
  directionUnit,
  colorMapUnit,
  shadowUnit,
  flowUnit,
  irradianceUnit
};

// The parts of shade.frag.glsl that this scene needs.
std::string definesOf(const scene::Scene& scene) {
  const scene::Look& look = scene.look;
  const LookNeeds needs = needsOf(scene);
  const auto number = [](const char* name, auto value) {
    return "#define " + std::string(name) + " " + std::to_string(static_cast<int>(value)) + "\n";
  };
  const auto flag = [](const char* name, bool on) {
    return on ? "#define " + std::string(name) + "\n" : std::string();
  };
  return number("LOOK", look.mode) + number("SHADING", scene::shadingOf(scene)) +
         number("TEXTURE", look.texture) + flag("CURVATURE", needs.curvature) + flag("SHADOW", needs.shadow) +
         flag("FLOW", needs.flow) + flag("FOG", look.fog > 0.0) + flag("FOG_BACKGROUND", !look.fogColor) +
         flag("ACCESSIBILITY", look.accessibility > 0.0 || look.mode == scene::LookMode::accessibility) +
         flag("RIDGES", look.ridges > 0.0) + flag("CONTOURS", look.contours > 0.0) +
         flag("SUGGESTIVE", look.suggestiveContours > 0.0);
}

}  // namespace

void LookPasses::ranges(FrameState& frame) {
  std::vector<volume::CurvatureStatistics> all;
  if (frame.volume)
    for (const Surface& surface : frame.surfaces)
      all.push_back(
          frame.volume->curvatureStatistics(frame.scene->derivatives.field, surface.value, frame.outward()));
  statistics_ = outerBounds(all);
}

void LookPasses::setSurfaces(FrameState& frame, Program& p) const {
  glm::vec4 opacities(1.0f);
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i) {
    const std::string name = "uAlbedos[" + std::to_string(i) + "]";
    p.set(name.c_str(), glm::vec3(frame.surfaces[i].albedo));
    opacities[static_cast<int>(i)] = static_cast<float>(frame.surfaces[i].opacity);
  }
  p.set("uOpacities", opacities);
}

void LookPasses::setLight(FrameState& frame, Program& p) const {
  const scene::Look& look = frame.scene->look;
  const scene::Light& light = frame.scene->light;
  p.set("uAmbient", static_cast<float>(look.ambient));
  p.set("uAmbientVariation", static_cast<float>(look.ambientVariation));
  p.set("uSpecular", static_cast<float>(look.specular));
  p.set("uShininess", static_cast<float>(look.shininess));
  p.set("uLight", glm::vec3(frame.towardLight()));
  p.set("uLightColor", glm::vec3(light.color * light.intensity));
  p.set("uHeadlight", static_cast<float>(light.headlight));
  p.set("uToneCool", glm::vec3(look.toneCool));
  p.set("uToneWarm", glm::vec3(look.toneWarm));
  if (needsOf(*frame.scene).shadow) p.setTexture("uLit", shadowUnit, frame.image(pass::shadow));
  p.set("uShadow", static_cast<float>(look.shadow));
  if (!needsOf(*frame.scene).light) return;
  p.setTexture("uIrradiance", irradianceUnit, frame.image(pass::irradiance));
  p.set("uExposure", exposureOf(*frame.scene, frame.light.get()));
}

void LookPasses::setMeasure(FrameState& frame, Program& p) {
  const scene::Look& look = frame.scene->look;
  p.setTexture("uKappa", kappaUnit, frame.image(pass::curvature, 0));
  p.setTexture("uDirection", directionUnit, frame.image(pass::curvature, 1));
  p.set("uFlat", static_cast<float>(frame.flatCurvature()));
  if (!isMeasure(look.mode)) return;
  const bool same = colors_ && colorsOf_.mode == look.mode && colorsOf_.colormap == look.colormap &&
                    colorsOf_.curvaturePoints == look.curvaturePoints;
  if (!same) {
    const MeasureColors colors = measureColors(look);
    colors_ = Texture::make2D(frame.gl, GL_RGB32F, colors.size);
    frame.gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    frame.gl->TextureSubImage2D(colors_.id(), 0, 0, 0, colors.size.x, colors.size.y, GL_RGB, GL_FLOAT,
                                colors.texels.data());
    colorsOf_ = look;
  }
  p.setTexture("uColorMap", colorMapUnit, colors_);
  p.set("uRange", glm::vec2(measureRange(*frame.scene, statistics_, frame.flatCurvature())));
}

void LookPasses::setLines(FrameState& frame, Program& p) const {
  const scene::Look& look = frame.scene->look;
  p.set("uRidges", static_cast<float>(look.ridges));
  p.set("uRidgeThresholds", glm::vec2(ridgeThresholds(*frame.scene, statistics_, frame.flatCurvature())));
  p.set("uRidgeColor", glm::vec3(look.ridgeColor));
  p.set("uValleyColor", glm::vec3(look.valleyColor));
  p.set("uContours", static_cast<float>(look.contours));
  p.set("uSuggestiveContours", static_cast<float>(look.suggestiveContours));
  p.set("uContourWidth", static_cast<float>(look.contourWidth * frame.raysPerWidth()));
  p.set("uContourColor", glm::vec3(look.contourColor));
  p.set("uCurvatureScale", static_cast<float>(curvatureScale(statistics_, frame.flatCurvature())));
}

void LookPasses::setOverlays(FrameState& frame, Program& p) const {
  const scene::Scene& scene = *frame.scene;
  const scene::Look& look = scene.look;
  const bool full = look.mode == scene::LookMode::accessibility;
  p.set("uAccessibility", static_cast<float>(full ? 1.0 : look.accessibility));
  p.set("uHollow", static_cast<float>(curvatureScale(statistics_, frame.flatCurvature())));
  if (needsOf(scene).flow) p.setTexture("uFlow", flowUnit, frame.image(pass::flow));
  p.set("uFlowStrength", static_cast<float>(look.mode == scene::LookMode::flow ? 1.0 : scene.flow.strength));
  p.set("uTextureScale", static_cast<float>(look.textureScale.value_or(1.0)));
  p.set("uDepthRange", glm::vec2(frame.view->depthRangeMm));
  p.set("uFog", static_cast<float>(look.fog));
  p.set("uFogColor", glm::vec3(look.fogColor.value_or(glm::dvec3(0.0))));
  p.set("uBackgroundTop", glm::vec3(look.backgroundTop));
  p.set("uBackgroundBottom", glm::vec3(look.backgroundBottom));
}

void LookPasses::drawShading(FrameState& frame) {
  Program& p = frame.program("shade.frag.glsl", definesOf(*frame.scene));
  frame.setView(p);
  frame.setPoint(p, surfaceUnit);
  setSurfaces(frame, p);
  setLight(frame, p);
  if (needsOf(*frame.scene).curvature) {
    setMeasure(frame, p);
    setLines(frame, p);
  }
  setOverlays(frame, p);
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

void LookPasses::layers(FrameState& frame, HitPasses& hits, DerivativePasses& derivatives,
                        EffectPasses& effects, LightPasses& light) {
  const Target& color = frame.target(pass::layers, {GL_RGBA16F});
  const Target& front = frame.images.at(pass::shade);
  const glm::ivec2 size = frame.raySize();
  const Gl& gl = *frame.gl;
  gl.BlitNamedFramebuffer(front.framebuffer.id(), color.framebuffer.id(), 0, 0, size.x, size.y, 0, 0, size.x,
                          size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  frame.hitsBehind.clear();
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
    } else if (frame.withGradient) {
      derivatives.gradient(frame);
    }
    const LookNeeds needs = needsOf(*frame.scene);
    if (needs.light) {
      light.irradiance(frame);
      appendHits(frame, kMostHitsBehind / static_cast<std::size_t>(frame.scene->isosurface.layers),
                 frame.hitsBehind);
    }
    if (needs.shadow) effects.shadow(frame);
    if (needs.flow) {
      effects.flowField(frame);
      effects.flow(frame);
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

void LookPasses::resolve(FrameState& frame, LightPasses& light) {
  const Target& target = frame.images.make(frame.gl, pass::resolve, frame.drawnSize(), {GL_RGBA8});
  drawResolved(frame, light, target, "");
  if (!frame.empty() && showsLegend(*frame.scene))
    drawLegendOver(frame, target, measureRange(*frame.scene, statistics_, frame.flatCurvature()));
  if (frame.request.linear)
    drawResolved(frame, light, frame.images.make(frame.gl, kLinearPicture, frame.drawnSize(), {GL_RGBA32F}),
                 "#define LINEAR\n");
  else
    frame.images.drop(kLinearPicture);
}

void LookPasses::drawResolved(FrameState& frame, LightPasses& light, const Target& target,
                              const std::string& defines) {
  frame.begin(target, frame.drawnSize());
  const bool environment = needsOf(*frame.scene).light && frame.light && frame.light->background;
  Program& p = frame.program("resolve.frag.glsl", defines + (environment ? "#define ENVIRONMENT\n" : ""));
  if (environment) light.setBackground(frame, p, 1);
  p.setTexture("uColor", 0, frame.image(isTransparent(*frame.scene) ? pass::layers : pass::shade));
  p.set("uSupersampling", frame.request.supersampling);
  p.set("uTileOrigin", frame.tileOrigin());
  p.set("uPictureSize", frame.request.size);
  p.set("uBackgroundTop", glm::vec3(frame.scene->look.backgroundTop));
  p.set("uBackgroundBottom", glm::vec3(frame.scene->look.backgroundBottom));
  frame.drawFullscreen(p);
}

}  // namespace isolux::render
