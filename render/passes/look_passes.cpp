#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "render/passes/curvature_ranges.h"
#include "render/passes/legend_overlay.h"
#include "render/passes/light_passes.h"
#include "render/passes/passes.h"
#include "render/passes/readback.h"
#include "render/passes/second_volume_pass.h"
#include "scene/color_maps.h"
#include "scene/looks.h"
#include "scene/opacity.h"
#include "scene/rules/needs.h"
#include "scene/settings/choice_names.h"
#include "scene/settings/settings.h"

namespace isolux::render {

namespace {

// Of all layers together.
constexpr std::size_t kMostHitsBehind = 1u << 20;

bool reportsHits(const FrameRequest& request, const scene::Scene& scene) {
  return request.hits != FrameRequest::Hits::none && scene::usesGi(scene);
}

// Texture units of shade.frag.glsl.
enum Unit {
  surfaceUnit,  // surfaceUnit to infoUnit: FrameState::setPoint()
  gradientUnit,
  infoUnit,
  colorMapUnit,
  firstInputUnit  // from here on: LookInput::samplers
};

// What the look reads of the passes that this frame needs.
std::vector<const LookInput*> inputsOf(const FrameState& frame) {
  std::vector<const LookInput*> inputs;
  for (const Pass* pass : frame.used)
    if (pass->isReadByLook(*frame.scene)) inputs.push_back(&pass->lookInput);
  return inputs;
}

template <class T>
std::string constantsOf(const std::string& prefix) {
  std::string defines;
  int number = 0;
  for (const std::string_view choice : scene::choiceNames<T>()) {
    std::string name(choice);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    defines.append("#define ").append(prefix).append(name).append(" ");
    defines.append(std::to_string(number++)).append("\n");
  }
  return defines;
}

// What there is of look.overlay: no bricks in one texture, and no texels without baked light.
scene::WorkOverlay overlayOf(const scene::Scene& scene, bool bricks) {
  const scene::WorkOverlay overlay = scene.look.overlay;
  const bool none = scene::isPlain(scene) || (overlay == scene::WorkOverlay::bricks && !bricks) ||
                    (overlay == scene::WorkOverlay::texels && !scene::usesGi(scene));
  return none ? scene::WorkOverlay::none : overlay;
}

// The parts of shade.frag.glsl that this scene needs.
std::string definesOf(const scene::Scene& scene, bool bricks, const std::vector<const LookInput*>& inputs) {
  const scene::Look& look = scene.look;
  const auto number = [](const char* name, auto value) {
    return "#define " + std::string(name) + " " + std::to_string(static_cast<int>(value)) + "\n";
  };
  const auto flag = [](const char* name, bool on) {
    return on ? "#define " + std::string(name) + "\n" : std::string();
  };
  const scene::LookKind kind = scene::lookInfo(look.mode).kind;
  static const std::string constants =
      constantsOf<scene::LookMode>("LOOK_") + constantsOf<scene::Shading>("SHADING_") +
      constantsOf<scene::SolidTexture>("TEXTURE_") + constantsOf<scene::WorkOverlay>("OVERLAY_");
  std::string defines =
      constants + flag("MEASURE", kind == scene::LookKind::measure) +
      flag("MEASURE_SQUARE", kind == scene::LookKind::square) + number("LOOK", look.mode) +
      number("SHADING", scene::shadingOf(scene)) + number("TEXTURE", look.texture) +
      flag("FOG", look.fog > 0.0) + flag("FOG_BACKGROUND", !look.fogColor) +
      flag("FACING", scene::variesByAngle(scene)) +
      flag("ACCESSIBILITY", look.accessibility > 0.0 || look.mode == scene::LookMode::accessibility) +
      number("OVERLAY", overlayOf(scene, bricks)) + flag("CREVICES", look.accessibilityPoints.has_value());
  for (const LookInput* input : inputs) defines += flag(input->define, *input->define != '\0');
  return defines;
}

// "uFogColor" for "look.fog_color".
std::string uniformOf(const std::string& path) {
  std::string name = "u";
  bool upper = true;
  for (const char c : path.substr(path.find('.') + 1)) {
    if (c != '_') name += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = c == '_';
  }
  return name;
}

// Each number and colour of the look reaches the uniform of its name, where the shader has one.
void setLook(const scene::Scene& scene, Program& p) {
  static const std::vector<std::pair<const scene::Setting*, std::string>> uniforms = [] {
    std::vector<std::pair<const scene::Setting*, std::string>> list;
    for (const scene::Setting& setting : scene::settings())
      if (scene::covers("look.", setting.path)) list.emplace_back(&setting, uniformOf(setting.path));
    return list;
  }();
  for (const auto& [setting, name] : uniforms) {
    if (!p.uses(name.c_str())) continue;
    const nlohmann::json value = setting->get(scene);
    if (value.is_number()) p.set(name.c_str(), value.get<float>());
    if (value.is_array())
      p.set(name.c_str(), glm::vec3(value[0].get<float>(), value[1].get<float>(), value[2].get<float>()));
  }
}

Texture colorTexture(const FrameState& frame, glm::ivec2 size, const std::vector<glm::vec3>& texels) {
  Texture colors = Texture::make2D(frame.gl, GL_RGB32F, size);
  colors.write(GL_RGB, GL_FLOAT, texels.data());
  return colors;
}

// Toward the lights that stand around the viewer, as photographers place them: unit, world.
struct OtherLights {
  glm::vec3 fill;
  std::array<glm::vec3, 2> rim;
};

OtherLights otherLights(const ViewUniforms& view, const glm::dvec3& towardKey) {
  const auto toward = [&](const glm::dvec3& d) {  // right, up, toward the viewer
    return glm::vec3(glm::normalize(d.x * view.rightWorld + d.y * view.upWorld - d.z * view.forwardWorld));
  };
  const double side = glm::dot(towardKey, view.rightWorld) > 0.0 ? -1.0 : 1.0;
  return {toward({0.8 * side, -0.15, 0.6}), {toward({-0.85, 0.35, -0.4}), toward({0.85, 0.35, -0.4})}};
}

// The look's own background shows through its fog.
bool fogIsBackground(const Asked& asked) {
  return asked.acts("look.fog_color") && !asked.scene.look.fogColor;
}

void declareRanges(Declaring& d) {
  d.writes(image::ranges).volume().isovalues().settings({"isosurface.inside"});
  // The curvature of the samples' spline, or of the one through them.
  d.input("derivatives.field", d.asked.scene.derivatives.field == scene::Field::cubic_interpolating);
  d.settings({"derivatives.scale"});
  if (scene::needsEdge(d.asked.scene)) d.settings({"derivatives.noise", "edge."});
  d.input("range of the second volume", readsSecondRange(d.asked.scene));
  if (readsSecondRange(d.asked.scene)) d.second();
}

void findRanges(FrameState& frame) {
  std::vector<volume::CurvatureStatistics> all;
  for (std::size_t i = 0; frame.volume && i < frame.surfaces.size(); ++i) {
    const GpuVolume& volume = frame.volumeOf(i);
    const double value = frame.surfaces[i].value;
    all.push_back(volume.curvatureStatistics(frame.curvatureField(), value, frame.outward(),
                                             volume::hiddenAt(volume.hidden(), value)));
    if (scene::needsEdge(*frame.scene))
      all[i].measures[scene::LookMode::edge_offset] =
          volume.edgeOffsets(frame.edgeField(), frame.edgeSearch(), value);
  }
  frame.statistics = outerBounds(all);
  if (frame.volume && readsSecondRange(*frame.scene)) frame.secondRange = automaticSecondRange(frame);
}

void setSurfaces(FrameState& frame, Program& p) {
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i)
    p.set(("uAlbedos[" + std::to_string(i) + "]").c_str(), glm::vec3(frame.surfaces[i].albedo));
  frame.setOfSurfaces(
      p, "uOpacities", [](const Surface& surface) { return surface.opacity; }, 1.0f);
  frame.setOfSurfaces(
      p, "uFacing", [](const Surface& surface) { return surface.facingOpacity; }, 1.0f);
}

void setLight(FrameState& frame, Program& p) {
  const scene::Light& light = frame.scene->light;
  p.set("uLight", glm::vec3(frame.towardLight()));
  p.set("uLightColor", glm::vec3(light.color * light.intensity));
  const OtherLights others = otherLights(frame.view.value(), frame.towardLight());
  const bool alone = light.setup == scene::LightSetup::key;
  p.set("uFill", static_cast<float>(alone ? 0.0 : light.fill));
  p.set("uRim", static_cast<float>(alone ? 0.0 : light.rim));
  p.set("uFillLight", others.fill);
  p.set("uRimLights[0]", others.rim[0]);
  p.set("uRimLights[1]", others.rim[1]);
  if (scene::showsOcclusion(*frame.scene)) {
    // A cell that reaches beyond the picture is as large as the others.
    const glm::vec2 rays(frame.request.size * frame.request.supersampling);
    const bool scaled = frame.request.tile.has_value();
    const glm::vec2 cells = scaled ? glm::vec2(frame.image(image::occlusion).size()) / rays
                                   : glm::vec2(1.0f / static_cast<float>(occlusionCell(frame.request)));
    p.set("uCellsPerRay", cells);
  }
  p.set("uHeadlight", static_cast<float>(light.headlight));
  if (scene::usesGi(*frame.scene)) p.set("uExposure", exposureOf(*frame.scene, frame.light.get()));
}

void setMeasure(FrameState& frame, Program& p) {
  const scene::Look& look = frame.scene->look;
  p.set("uFlat", static_cast<float>(frame.flatCurvature()));
  if (!scene::isMeasure(look.mode)) return;
  LookTextures& textures = *frame.lookTextures;
  const bool same = textures.colors && textures.colorsOf.mode == look.mode &&
                    textures.colorsOf.colormap == look.colormap &&
                    textures.colorsOf.colormapPoints == look.colormapPoints &&
                    textures.colorsOf.curvaturePoints == look.curvaturePoints;
  if (!same) {
    const MeasureColors colors = measureColors(look);
    textures.colors = colorTexture(frame, colors.size, colors.texels);
    textures.colorsOf = look;
  }
  p.setTexture("uColorMap", colorMapUnit, textures.colors);
  p.set("uRange", glm::vec2(measureRange(*frame.scene, frame.statistics, frame.flatCurvature())));
}

void setSecond(FrameState& frame, Program& p, int unit) {
  const scene::ColorVolume& color = frame.scene->color;
  LookTextures& textures = *frame.lookTextures;
  if (!textures.secondColors || textures.secondColorsOf != color.map) {
    textures.secondColors = colorTexture(frame, {kSecondColors, 1}, secondColors(*frame.scene));
    textures.secondColorsOf = color.map;
  }
  p.setTexture("uSecondColors", unit, textures.secondColors);
  p.set("uSecondRange", glm::vec2(secondRange(frame)));
  p.set("uSecondStrength", static_cast<float>(color.strength));
  p.set("uSecondFades", color.fade ? 1 : 0);
  p.set("uIsolines", static_cast<float>(color.isolines));
  p.set("uIsolineWidth", static_cast<float>(color.isolineWidth * frame.raysPerWidth()));
}

void setCrevices(FrameState& frame, Program& p, int unit) {
  const auto& points = frame.scene->look.accessibilityPoints;
  LookTextures& textures = *frame.lookTextures;
  if (!textures.crevices || textures.crevicesOf != points) {
    constexpr int samples = 256;
    textures.crevices = colorTexture(frame, {samples, 1}, scene::pointSamples(*points, samples));
    textures.crevicesOf = points;
  }
  p.setTexture("uCrevices", unit, textures.crevices);
}

void setOverlays(FrameState& frame, Program& p) {
  const scene::Scene& scene = *frame.scene;
  const scene::Look& look = scene.look;
  const bool full = look.mode == scene::LookMode::accessibility;
  p.set("uAccessibility", static_cast<float>(full ? 1.0 : look.accessibility));
  p.set("uHollow", static_cast<float>(curvatureScale(frame.statistics, frame.flatCurvature())));
  p.set("uFlowStrength", static_cast<float>(look.mode == scene::LookMode::flow ? 1.0 : scene.flow.strength));
  p.set("uTextureScale", static_cast<float>(look.textureScale.value_or(1.0)));
  p.set("uDepthRange", glm::vec2(frame.view->depthRangeMm));
  if (look.overlay != scene::WorkOverlay::none) {
    const int cells = look.overlay == scene::WorkOverlay::bricks
                          ? brickCells
                          : frame.volume->surface().blocks().blockCells();
    p.set("uCellsPerVoxel", look.overlay == scene::WorkOverlay::texels
                                ? frame.lighting->texelsPerVoxel()
                                : glm::vec3(1.0f / static_cast<float>(cells)));
  }
  p.set("uFogColor", glm::vec3(look.fogColor.value_or(glm::dvec3(0.0))));
}

void declareShade(Declaring& d) {
  const bool transparent = scene::isTransparent(d.asked.scene);
  d.reads(image::surface).writes(transparent ? image::front : image::color, 8);
  d.input("surfaces let light through", transparent);
  // Where no ray can hit anything, colours read nothing of the surface.
  if (d.asked.volume.crossed) {
    if (scene::needsGradient(d.asked.scene)) d.reads(image::gradient);  // FrameState::setPoint() binds them
    for (const Pass& pass : d.passes)
      if (pass.isReadByLook(d.asked.scene)) d.reads(pass.lookInput.image);
  }
  d.settings({"camera.", "isosurface."},
             {"isosurface.inside", "isosurface.layers", "isosurface.ghost_opacity"});
  d.settings({"surfaces.#.albedo", "surfaces.#.opacity", "surfaces.#.facing_opacity"});
  d.settings({"look."}, {"look.legend", "look.legend_corner", "look.background_top", "look.background_bottom",
                         "look.contour_width", "look.ridge_threshold", "look.ridge_width",
                         "look.ridge_width_unit", "look.ridge_length"});
  d.input("the second volume is shown", scene::showsSecondVolume(d.asked.scene));
  if (scene::showsSecondVolume(d.asked.scene))
    d.settings({"color.map", "color.low", "color.high", "color.strength", "color.fade", "color.isolines",
                "color.isoline_width"});
  d.settings({"flow.strength", "light.setup", "light.space", "light.direction", "light.color",
              "light.intensity", "light.fill", "light.rim", "light.headlight"});
  // Normals are turned to the viewer, and curvatures have their sign when they come.
  if (d.asked.scene.look.mode == scene::LookMode::normal) d.settings({"isosurface.inside"});
  if (d.asked.acts("look.inner_tint") && d.asked.scene.look.innerTint != glm::dvec3(1.0))
    d.settings({"isosurface.inside"});
  if (fogIsBackground(d.asked)) d.settings({"look.background_top", "look.background_bottom"});
  addExposure(d);
  if (scene::showsGloss(d.asked.scene)) GlossUniforms::declare(d);
}

Program& preparedShade(FrameState& frame) {
  const std::vector<const LookInput*> inputs = inputsOf(frame);
  const bool gloss = scene::showsGloss(*frame.scene);
  Program& p = frame.program(
      "shade.frag.glsl", frame.surfaceDefines() + definesOf(*frame.scene, frame.bricks() != nullptr, inputs) +
                             (gloss ? frame.lighting->lampDefines(frame) : std::string()));
  frame.setView(p);
  frame.setPoint(p, surfaceUnit);
  int unit = firstInputUnit;
  for (const LookInput* input : inputs)
    for (std::size_t i = 0; i < input->samplers.size(); ++i)
      if (p.uses(input->samplers[i])) p.setTexture(input->samplers[i], unit++, frame.image(input->image, i));
  if (gloss) frame.lookTextures->gloss.set(frame, p, unit++);
  if (scene::showsSecondVolume(*frame.scene)) setSecond(frame, p, unit++);
  if (p.uses("uCrevices")) setCrevices(frame, p, unit);
  setSurfaces(frame, p);
  setLook(*frame.scene, p);
  setLight(frame, p);
  if (scene::needsCurvature(*frame.scene) || scene::needsEdge(*frame.scene)) setMeasure(frame, p);
  setOverlays(frame, p);
  return p;
}

// The rows of frame.bandRow to `color`, whose first row that is.
void drawBand(FrameState& frame) {
  const glm::ivec2 size(frame.raySize().x, frame.bandRows);
  Target& target = frame.images.make(frame.gl, image::color, size, {GL_RGBA16F});
  frame.clear(target, {kZero});
  if (frame.empty()) return;
  Program& p = preparedShade(frame);
  p.set("uFirstRow", frame.bandRow);
  const glm::ivec2 low(0, frame.bandRow);
  if (frame.gradientInStrips) setGradientStrip(frame, p, gradientUnit, frame.bandRow, frame.bandRows);
  std::vector<volume::Rectangle> parts = volume::partsOf(frame.area(), {low, size});
  for (volume::Rectangle& part : parts) part.low -= low;
  frame.begin(target);
  frame.drawRectangles(p, parts);
  for (const volume::Rectangle& part : parts)
    for (int y = 0; y < part.size.y; ++y)
      target.drawn.add(part.low.y + y, part.low.x, part.low.x + part.size.x);
}

void drawShade(FrameState& frame) {
  const Gl& gl = *frame.gl;
  if (!frame.layer.empty()) {  // premultiplied, front to back
    frame.begin(frame.images.at(image::color));
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    frame.drawRectangles(preparedShade(frame), frame.area().rectangles());
    gl.Disable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    return;
  }
  const bool transparent = scene::isTransparent(*frame.scene);
  if (frame.bandRows > 0) return drawBand(frame);
  Target& target = frame.target(transparent ? image::front : image::color, {GL_RGBA16F});
  if (frame.empty())
    frame.clear(target, {kZero});
  else
    frame.drawHits(target, preparedShade(frame));
}

void declareLayers(Declaring& d) {
  if (reportsHits(d.asked.request, d.asked.scene)) d.input("points behind", d.asked.request.hits);
  d.reads(image::surface);
  if (!scene::isTransparent(d.asked.scene)) {
    d.writes("layers").notNeeded("every surface is opaque");
    return;
  }
  readsOfGroups(d, image::surface);  // each casts on behind its own
  d.reads(image::front).writes(image::color, 8).settings({"isosurface.layers"});
  // It draws the passes of a crossing again: it depends on what they do, and reads what they read of others.
  const std::vector<bool> used = usedPasses(d.earlier, {image::front});
  std::set<std::string> own;
  for (std::size_t i = 0; i < d.earlier.size(); ++i)
    if (used[i] && d.passes[i].kind.ofCrossing)
      own.insert(d.earlier[i].writes.begin(), d.earlier[i].writes.end());
  for (std::size_t i = 0; i < d.earlier.size(); ++i) {
    if (!used[i] || !d.passes[i].kind.ofCrossing) continue;
    for (const Parameter& parameter : d.earlier[i].parameters) d.add(parameter);
    for (const std::string& image : d.earlier[i].reads)
      if (own.count(image) == 0) d.reads(image.c_str());
  }
}

void drawLayers(FrameState& frame) {
  Target& color = frame.target(image::color, {GL_RGBA16F});
  const Target& front = frame.images.at(image::front);
  frame.copy(front, color);
  frame.hitsBehind = {};
  if (frame.empty()) return;
  const int layers = frame.scene->isosurface.layers;
  // Each layer reads the surface image of the one before it: two names in turn.
  const char* const names[2] = {" of a layer", " of the next layer"};
  frame.layerBefore.clear();
  frame.anyBehind = true;
  for (int layer = 1; layer < layers && frame.anyBehind; ++layer) {
    frame.layer = names[layer % 2];
    for (const Pass* pass : frame.used)
      if (pass->kind.ofCrossing && frame.anyBehind) pass->run(frame);  // the first is the cast
    if (frame.request.stop.stop_requested()) break;
    if (frame.anyBehind && reportsHits(frame.request, *frame.scene))
      appendHits(frame, kMostHitsBehind / static_cast<std::size_t>(layers), frame.outward(),
                 frame.hitsBehind);
    frame.layerBefore = frame.layer;
  }
  frame.layer.clear();
}

}  // namespace

Pass rangesPass() {
  const auto isRead = [](const scene::Scene& scene) {  // FrameState::statistics
    return readsCurvatureRanges(scene) || readsSecondRange(scene);
  };
  return {"ranges", declareRanges, findRanges, {image::ranges, "", {}, isRead}};
}

PassList lookPasses() {
  return {
      // Shades the first crossing in linear colour; a layer is blended behind the colour drawn so far.
      {pass::shade, declareShade, drawShade, {}, {.ofCrossing = true}},
      // Draws crossings behind transparent surfaces, one after another until none is visible. For each
      // crossing, runs all passes from cast to shade again.
      {pass::layers, declareLayers, drawLayers, {}, {.castsRays = true}},
  };
}

}  // namespace isolux::render
