#include "render/passes/curvature_ranges.h"
#include "render/passes/cut_faces_pass.h"
#include "render/passes/legend_overlay.h"
#include "render/passes/light_passes.h"
#include "render/passes/passes.h"
#include "render/passes/second_volume_pass.h"
#include "scene/rules/gi_choice.h"
#include "scene/rules/needs.h"
#include "scene/rules/tone_curve.h"

namespace isolux::render {

namespace {

// Texture units of resolve.frag.glsl.
constexpr int kColorUnit = 0, kEnvironmentUnit = 1, kCutFacesUnit = 2, kGroundUnit = 4;

// Whether the environment, or the ground with the surface's shadow, is seen behind the surface, if the light
// has one.
bool showsEnvironment(const scene::Scene& scene, bool has) {
  return has && scene::usesGi(scene) && !scene.picture.transparent;
}

bool showsGround(const scene::Scene& scene, bool has) {
  return has && scene.gi.ground && scene::giChoiceOf(scene).wanted;
}

bool environmentIsSeen(const FrameState& frame) {
  return showsEnvironment(*frame.scene, frame.light && frame.light->background);
}

bool groundIsSeen(const FrameState& frame) {
  return showsGround(*frame.scene, frame.light && frame.light->ground);
}

// What resolve.frag.glsl reads for the colour behind the surface.
void setBehind(const FrameState& frame, Program& p) {
  p.set("uSupersampling", frame.request.supersampling);
  p.set("uTileOrigin", frame.tileOrigin());
  p.set("uPictureSize", frame.request.size);
  p.set("uBackgroundTop", glm::vec3(frame.scene->look.backgroundTop));
  p.set("uBackgroundBottom", glm::vec3(frame.scene->look.backgroundBottom));
}

std::string curveOf(const FrameState& frame) {
  return scene::isFilmic(*frame.scene) ? "#define FILMIC\n" : "";
}

// The legend's place.
std::optional<Tile> drawLegendOf(FrameState& frame, const Target& picture) {
  const scene::Scene& scene = *frame.scene;
  if (scene::isMeasure(scene.look.mode))
    return drawLegendOver(frame, picture,
                          measureLegend(scene, measureRange(scene, frame.statistics, frame.flatCurvature())));
  if (frame.second) return drawLegendOver(frame, picture, secondLegend(frame));
  return {};
}

void declareBackground(Declaring& d) {
  d.writes(image::background).pictureSize().settings({"look.background_top", "look.background_bottom"});
  d.notNeeded(d.asked.scene.picture.transparent ? "the picture is transparent"
              : showsEnvironment(d.asked.scene, d.asked.light.background)
                  ? "the environment is behind the surface"
                  : "the ground is behind the surface");
}

void drawBackground(FrameState& frame) {
  // Nobody else reads it in a frame that keeps no images: the picture is drawn over it.
  const char* const name = frame.request.keepImages ? image::background : image::picture;
  const Target& target = frame.images.make(frame.gl, name, frame.drawnSize(), {GL_RGBA8});
  frame.begin(target, frame.drawnSize());
  Program& p = frame.program("resolve.frag.glsl", "#define NOTHING_ELSE\n");
  setBehind(frame, p);
  frame.drawFullscreen(p);
}

void declareResolve(Declaring& d) {
  const scene::Scene& scene = d.asked.scene;
  const bool ground = showsGround(scene, d.asked.light.ground != 0);
  d.reads(image::color).writes(image::picture).pictureSize().settings({"look.legend", "look.legend_corner"});
  d.input("linear picture", d.asked.request.linear).settings({"picture.transparent"});
  d.input("tone curve", scene::isFilmic(scene));
  d.input("cut faces are shown", scene::showsCutFaces(scene));
  if (scene::showsCutFaces(scene)) {
    d.reads(image::cutFaces).settings({"slice.level", "slice.width", "slice.map"});
    d.volume();  // what is automatic of them
  }
  if (showsEnvironment(scene, d.asked.light.background)) {
    d.input("light", d.asked.light.version).settings({"camera."});
    addExposure(d);
  } else if (ground && !scene.picture.transparent) {
    d.settings({"look.background_top", "look.background_bottom"});
  } else if (!scene.picture.transparent) {
    d.reads(image::background);
  }
  if (ground) d.input("ground", d.asked.light.ground).settings({"gi.ground", "camera."});
  if (scene::showsLegend(scene) && d.asked.volume.crossed && readsCurvatureRanges(scene))
    d.reads(image::ranges);
  d.input("legend of the second volume", scene::showsLegend(scene) && scene::showsSecondVolume(scene));
  if (scene::showsLegend(scene) && scene::showsSecondVolume(scene)) {
    d.second().settings({"color.map", "color.low", "color.high"});
    if (d.asked.volume.crossed && readsSecondRange(scene)) d.reads(image::ranges);
  }
}

Program& preparedResolve(FrameState& frame, const std::string& defines) {
  const bool environment = environmentIsSeen(frame);
  const bool ground = groundIsSeen(frame);
  const bool faces = frame.cutFaceColors != nullptr;
  Program& p = frame.program("resolve.frag.glsl",
                             defines + (environment ? "#define ENVIRONMENT\n" : "") +
                                 (ground ? "#define GROUND\n" : "") + (faces ? "#define CUT_FACES\n" : "") +
                                 (frame.scene->picture.transparent ? "#define TRANSPARENT\n" : ""));
  if (faces) setCutFaces(frame, p, kCutFacesUnit);
  if (environment) frame.lighting->setBackground(frame, p, kEnvironmentUnit);
  if (ground) frame.lighting->setGround(frame, p, kGroundUnit);
  p.setTexture("uColor", kColorUnit, frame.image(image::color));
  p.set("uColorLow", frame.raysLow() + glm::ivec2(0, frame.bandRow));
  setBehind(frame, p);
  return p;
}

void resolveAll(FrameState& frame, const Target& target, const std::string& defines) {
  Program& p = preparedResolve(frame, defines);
  frame.begin(target, frame.drawnSize());
  frame.drawFullscreen(p);
}

// The background's own pixels, with the surface's over them.
void resolveHits(FrameState& frame, Target& target) {
  if (frame.request.keepImages) frame.copy(frame.images.at(image::background), target);
  Program& p = preparedResolve(frame, curveOf(frame));
  frame.begin(target, frame.drawnSize());
  frame.drawRectangles(p, frame.surfacePixels());
}

void drawResolve(FrameState& frame) {
  Target& target = frame.images.make(frame.gl, image::picture, frame.drawnSize(), {GL_RGBA8});
  if (environmentIsSeen(frame) || groundIsSeen(frame) || frame.scene->picture.transparent)
    resolveAll(frame, target, curveOf(frame));
  else
    resolveHits(frame, target);
  frame.legend.reset();
  if (!frame.empty() && scene::showsLegend(*frame.scene)) frame.legend = drawLegendOf(frame, target);
  if (frame.request.linear)
    resolveAll(frame, frame.images.make(frame.gl, image::linear, frame.drawnSize(), {GL_RGBA32F}),
               "#define LINEAR\n");
  else
    frame.images.drop(image::linear);
}

}  // namespace

PassList resolvePasses() {
  return {
      // Draws the pixels without a surface, if they do not depend on the view.
      {"background", declareBackground, drawBackground},
      // Adds the background, averages supersamples, encodes sRGB and adds the legend.
      {pass::resolve, declareResolve, drawResolve},
  };
}

}  // namespace isolux::render
