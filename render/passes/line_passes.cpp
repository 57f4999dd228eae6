#include <algorithm>

#include "render/passes/curvature_ranges.h"
#include "render/passes/passes.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

constexpr float kUnknown[4] = {3e38f, 3e38f, 0.0f, 0.0f};
constexpr float kNoLine[4] = {0.0f, 0.0f, 1000.0f, 0.0f};
// Rays that a line is followed each way at most, and that differences are taken over: parts of the picture's
// height, so that lines are the same at all its sizes, as far as tiles can have margins of it.
double mostRays(int height) {
  return std::min(height / 8.0, 384.0);
}
double mostDifference(int height) {
  return std::clamp(height / 24.0, 1.0, 256.0);
}

// The images of the line fields, in their order.
struct LineKind {
  const char* define;
  const char* place;    // its place among the images
  const char* sampler;  // of lines.frag.glsl
};
constexpr LineKind kRidgeLines{"RIDGES", "AT_RIDGES", "uRidgeField"},
    kValleyLines{"RIDGES", "AT_VALLEYS", "uValleyField"},
    kSuggestiveLines{"SUGGESTIVE", "AT_SUGGESTIVE", "uSuggestiveField"},
    kContourLines{"CONTOURS", "AT_CONTOURS", "uContourField"};

std::vector<LineKind> kindsOf(const scene::Scene& scene) {
  std::vector<LineKind> kinds;
  if (scene.look.ridges > 0.0) kinds = {kRidgeLines, kValleyLines};
  if (scene.look.suggestiveContours > 0.0) kinds.push_back(kSuggestiveLines);
  if (scene::contoursOf(scene) > 0.0) kinds.push_back(kContourLines);
  return kinds;
}

std::string definesOfLines(const scene::Scene& scene) {
  std::string defines, last;
  int place = 0;
  for (const LineKind& kind : kindsOf(scene)) {
    if (kind.define != last) defines += "#define " + (last = kind.define) + "\n";
    defines += "#define " + std::string(kind.place) + " " + std::to_string(place++) + "\n";
  }
  return defines;
}

int heightInRays(const FrameState& frame) {
  return frame.request.size.y * frame.request.supersampling;
}

// Voxels, or the scale that curvature is taken at, mm: what varies faster is not the surface's doing.
float detailOf(const FrameState& frame, double voxels) {
  const double voxel = frame.volume->grid().geometry().leastSpacingMm();
  return static_cast<float>(std::max(voxels * voxel, 0.5 * scene::derivativesScale(*frame.scene)));
}
// Differences are taken over most of a voxel; gaps of lines are closed that are a little longer than two.
constexpr double kDifferences = 0.75, kGap = 2.5;

// Points with the gradients that curvature is of, whose tangent planes its directions lie in: not those of
// shading.
void setPoints(FrameState& frame, Program& p, int unit) {
  frame.setView(p);
  frame.setPoint(p, unit);
  p.setTexture("uGradient", unit + 1, frame.image(image::tangents));
}

void setNeighbours(FrameState& frame, Program& p, int unit) {
  setPoints(frame, p, unit);
  p.setTexture("uKappa", unit + 3, frame.image(image::curvature, 0));
  p.setTexture("uDirection", unit + 4, frame.image(image::curvature, 1));
  p.set("uDetail", detailOf(frame, kDifferences));
  p.set("uMostDifference", static_cast<float>(mostDifference(heightInRays(frame))));
}

glm::dvec2 thresholdsOf(const FrameState& frame) {
  return ridgeThresholds(*frame.scene, frame.statistics, frame.flatCurvature());
}

void dependOnPoints(Declaring& d) {
  d.reads(image::surface).reads(image::tangents).reads(image::curvature).volume().pictureSize();
  d.settings({"camera.", "isosurface.inside"});
}

void dependOnRanges(Declaring& d) {
  if (readsCurvatureRanges(d.asked.scene)) d.reads(image::ranges);
  d.settings({"look.ridge_threshold"});
}

void declareExtrema(Declaring& d) {
  dependOnPoints(d);
  d.writes(image::extrema, 8);
}

void drawExtrema(FrameState& frame) {
  Target& target = frame.target(image::extrema, {GL_RG32F});
  if (frame.clearIfEmpty(target, {kUnknown})) return;
  Program& p = frame.program("extrema.frag.glsl");
  setNeighbours(frame, p, 0);
  frame.drawHits(target, p);
}

void declareLineField(Declaring& d) {
  dependOnPoints(d);
  dependOnRanges(d);
  d.writes(image::lineField, 8 * static_cast<int>(kindsOf(d.asked.scene).size()));
  const scene::Look& look = d.asked.scene.look;
  d.input("kinds of lines", look.ridges > 0.0, look.suggestiveContours > 0.0,
          scene::contoursOf(d.asked.scene) > 0.0);
  if (look.ridges > 0.0) d.reads(image::extrema);
  d.settings({"look.contour_width"}).input("pixel ratio", d.asked.request.pixelRatio);
}

void drawLineField(FrameState& frame) {
  const std::size_t kinds = kindsOf(*frame.scene).size();
  Target& target = frame.target(image::lineField, std::vector<GLenum>(kinds, GL_RGBA16F));
  if (frame.clearIfEmpty(target, {kNoLine})) return;
  Program& p = frame.program("line_field.frag.glsl", definesOfLines(*frame.scene));
  setNeighbours(frame, p, 0);
  if (frame.scene->look.ridges > 0.0) p.setTexture("uExtrema", 5, frame.image(image::extrema));
  p.set("uRidgeThresholds", glm::vec2(thresholdsOf(frame)));
  p.set("uMostRays", static_cast<float>(mostRays(heightInRays(frame))));
  p.set("uContourWidth", static_cast<float>(frame.scene->look.contourWidth * frame.raysPerWidth()));
  p.set("uCurvatureScale", static_cast<float>(curvatureScale(frame.statistics, frame.flatCurvature())));
  frame.drawHits(target, p);
}

void declareLines(Declaring& d) {
  dependOnPoints(d);
  dependOnRanges(d);
  d.reads(image::lineField).writes(image::lines, 4);
  d.settings({"look.contour_width", "look.ridge_width", "look.ridge_width_unit", "look.ridge_length"});
  d.input("pixel ratio", d.asked.request.pixelRatio);
}

void drawLines(FrameState& frame) {
  Target& target = frame.target(image::lines, {GL_RGBA8});
  if (frame.clearIfEmpty(target, {kZero})) return;
  const scene::Look& look = frame.scene->look;
  Program& p = frame.program("lines.frag.glsl", definesOfLines(*frame.scene));
  setPoints(frame, p, 0);
  int unit = 3;
  for (const LineKind& line : kindsOf(*frame.scene)) {
    p.setTexture(line.sampler, unit, frame.image(image::lineField, static_cast<std::size_t>(unit - 3)));
    ++unit;
  }
  const double pixel = frame.raysPerWidth();
  const bool inMm = look.ridgeWidthUnit == scene::LengthUnit::mm;
  p.set("uPixel", static_cast<float>(pixel));
  const glm::vec2 low(-frame.raysLow());
  p.set("uDrawn", glm::vec4(low, low + glm::vec2(frame.drawnSize() * frame.request.supersampling)));
  p.set("uMostRays", static_cast<float>(mostRays(heightInRays(frame))));
  p.set("uDetail", detailOf(frame, kDifferences));
  p.set("uGap", detailOf(frame, kGap));
  p.set("uRidgeRays", static_cast<float>(inMm ? 0.0 : look.ridgeWidth * pixel));
  p.set("uRidgeMm", static_cast<float>(inMm ? look.ridgeWidth : 0.0));
  p.set("uRidgeLengths", glm::vec2(ridgeLengths(*frame.scene, thresholdsOf(frame))));
  p.set("uContourWidth", static_cast<float>(look.contourWidth * pixel));
  frame.drawHits(target, p);
}

}  // namespace

PassList linePasses() {
  const Pass::Kind ofCrossing{.ofCrossing = true};
  return {
      // Computes the change of each principal curvature along its own direction: 0 on ridges and valleys.
      {"extrema", declareExtrema, drawExtrema, {}, ofCrossing},
      // Finds the lines near each pixel: ridges and valleys, suggestive contours, outlines.
      {"line field", declareLineField, drawLineField, {}, ofCrossing},
      // Computes the coverage of each pixel by lines that are long and strong enough.
      {"lines", declareLines, drawLines, {image::lines, "LINES", {"uLines"}, scene::drawsLines}, ofCrossing},
  };
}

double reachOfLines(const scene::Scene& scene, int heightInRays) {
  if (!scene::drawsLines(scene)) return 0.0;
  return mostRays(heightInRays) + std::max(1.5 * mostDifference(heightInRays), mostRays(heightInRays)) +
         heightInRays / 90.0;
}

}  // namespace isolux::render
