#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "render/passes/cut_faces_pass.h"
#include "render/passes/passes.h"

namespace isolux::render {

namespace {

constexpr float kNoBracket[4] = {1.0f, 0.0f, 0.0f, 0.0f};
constexpr float kNoSurface[4] = {0.0f, 0.0f, 0.0f, -1.0f};

bool isExact(const FrameState& frame) {
  return frame.scene->hit.method == scene::HitMethod::exact;
}

// Of exact hits only the value error and the number of a group need more than half floats.
bool hasSmallInfos(const scene::Scene& scene, const FrameRequest& request, std::size_t groups) {
  return scene.hit.method == scene::HitMethod::exact && !request.asksFor(Aov::value_error) && groups == 1;
}

Target& surfaceTargetNamed(FrameState& frame, const std::string& name) {
  const GLenum info = hasSmallInfos(*frame.scene, frame.request, frame.groups()) ? GL_RG16F : GL_RG32F;
  return frame.target(name, {GL_RGBA32F, info});
}

// Exact hits are the surface points themselves; sampled ones are brackets yet.
Target& castTarget(FrameState& frame) {
  return isExact(frame) ? surfaceTargetNamed(frame, frame.castName(image::surface))
                        : frame.target(frame.castName(image::bracket), {GL_RGBA32F});
}

void clearHits(const FrameState& frame, Target& target) {
  if (isExact(frame))
    frame.clear(target, {kNoSurface, kZero});
  else
    frame.clear(target, {kNoBracket});
}

void declareBlocks(Declaring& d) {
  d.volume().isovalues().settings({"hit.field"}).input("graphics copy of the volume", d.asked.volume.made);
  d.writes(image::activeBlocks);
}

void findBlocks(FrameState& frame) {
  if (!frame.volume) return;
  frame.forVolumes([&] { frame.volume->activate(frame.scene->hit.field, valuesOf(frame.volumeSurfaces())); });
}

std::size_t bytesOfBlocks(const FrameState& frame) {
  std::size_t bytes = 0;
  for (const auto& volume : frame.volumes) bytes += volume->blockBytes();
  return bytes;
}

void declareSegments(Declaring& d) {
  if (d.asked.onProcessor.casts) {
    d.writes(image::segments).notNeeded("the processor casts the rays");
    return;
  }
  d.reads(image::activeBlocks).writes(image::segments);
  d.settings({"camera."}).pictureSize();
}

void findStarts(FrameState& frame, RayStarts& starts) {
  if (frame.groupIsEmpty()) return starts.clear(frame.raySize());
  SurfaceBlocks& surface = frame.volume->surface();
  surface.prepareMasks(frame.scene->hit);
  const int shift = RayStarts::tileShift(frame.raySize());
  const volume::BlockMasks blocks{surface.blocks().dims(), surface.masks(), surface.blocks().blockCells()};
  starts.update(
      volume::startDepths(frame.rays(), frame.raySize(), frame.volume->grid().dims(), blocks, 1 << shift),
      shift, frame.raySize());
}

void findSegments(FrameState& frame) {
  const std::size_t volumes = std::max<std::size_t>(1, frame.volumes.size());
  while (frame.starts.size() < volumes) frame.starts.emplace_back(frame.gl);
  frame.forVolumes([&] { findStarts(frame, frame.rayStarts()); });
}

std::size_t bytesOfSegments(const FrameState& frame) {
  std::size_t bytes = 0;
  for (const RayStarts& starts : frame.starts) bytes += starts.bytes();
  return bytes;
}

void declareBricks(Declaring& d) {
  d.writes(image::bricks);
  d.notNeeded(d.asked.onProcessor.all ? "nothing on the graphics card reads voxels"
                                      : "the volume is one texture");
  d.volume().input("graphics copy of the volume", d.asked.volume.made);
  if (!d.asked.bricks.inUse) return;
  d.input("graphics memory", d.asked.bricks.made).input("what rays ask for", d.asked.bricks.asked);
}

void uploadBricks(FrameState& frame) {
  Bricks& bricks = *frame.volume->bricks();
  if (frame.request.brickUploadBytes > 0) bricks.serve(bricks.frameRound(), frame.request.brickUploadBytes);
}

std::size_t bytesOfBricks(const FrameState& frame) {
  return frame.volume && frame.volume->bricks() ? frame.volume->bricks()->bytes() : 0;
}

void writesOfGroups(Declaring& d, const char* image, int bytesPerRay) {
  const std::size_t groups = d.asked.groups();
  for (std::size_t group = 0; group < groups; ++group) d.writes(ofGroup(image, group, groups), bytesPerRay);
}

void declareCast(Declaring& d) {
  const bool exact = d.asked.scene.hit.method == scene::HitMethod::exact;
  d.reads(image::activeBlocks);
  const int bytes = hasSmallInfos(d.asked.scene, d.asked.request, d.asked.groups()) ? 20 : exact ? 24 : 16;
  writesOfGroups(d, exact ? image::surface : image::bracket, bytes);
  d.volume().isovalues().cuts().pictureSize().settings({"camera.", "hit."}, {"hit.refinements"});
  d.input("cut faces are shown", scene::showsCutFaces(d.asked.scene));
  if (scene::showsCutFaces(d.asked.scene)) d.reads(image::cutFaces);
  d.input("executor", d.asked.onProcessor.casts);
  if (exact) d.input("value error", d.asked.request.asksFor(Aov::value_error));
  if (d.asked.onProcessor.casts) return;
  d.reads(image::segments);
  d.input("volume in bricks", d.asked.bricks.inUse);
  if (d.asked.bricks.inUse) d.reads(image::bricks);
}

enum class Rays { all, again, behind };

Program& castProgram(FrameState& frame, Rays rays) {
  const scene::Hit& hit = frame.scene->hit;
  std::string defines = "#define TILES\n" + traceDefines(frame);
  if (rays == Rays::behind) defines += "#define BEHIND\n";
  // Else nobody reads how far the field at an exact hit is off, which takes a second look at its cell.
  if (rays != Rays::behind && frame.request.asksFor(Aov::value_error)) defines += "#define VALUE_ERROR\n";
  if (rays == Rays::again) defines += "#define AGAIN\n";
  if (rays == Rays::behind && frame.groups() > 1) defines += "#define GROUPS\n";
  if (frame.cutFaceColors) defines += "#define CUT_FACES\n";
  Program& p = frame.program("cast.frag.glsl", defines);
  setTrace(frame, p);
  frame.rayStarts().bind(p, 2);
  if (frame.cutFaceColors) p.setTexture("uCutFaces", 7, frame.images.at(image::cutFaces).images[0]);
  if (!isExact(frame)) {
    p.set("uStep", static_cast<float>(1.0 / hit.rate));
    p.set("uNearFactor", static_cast<float>(hit.nearFactor));
    p.set("uNearThreshold",
          static_cast<float>(*hit.nearThreshold / std::abs(frame.volume->dataUnitsPerTexel(hit.field))));
    const double diagonal = glm::length(glm::dvec3(frame.volume->grid().dims()));
    p.set("uMaxSteps", static_cast<int>(diagonal * (hit.rate * hit.nearFactor + 2.0) + 16.0));
  }
  return p;
}

void castBehind(FrameState& frame) {
  Target& target = castTarget(frame);
  frame.begin(target);
  clearHits(frame, target);
  frame.anyBehind = frame.group > 0 && frame.anyBehind;
  if (frame.groupIsEmpty()) return;
  Program& p = castProgram(frame, Rays::behind);
  const Target& surface = frame.images.at(frame.castName(image::surface) + frame.layerBefore);
  if (frame.groups() > 1) {
    p.setTexture("uNearest", 8, frame.images.at(image::surface + frame.layerBefore).images[1]);
    p.set("uFirst", static_cast<int>(frame.firstSurface()));
  }
  p.setTexture("uSurface", 4, surface.images[0]);
  p.setTexture("uInfo", 5, surface.images[1]);
  p.setTexture("uColor", 6, frame.images.at(image::color).images[0]);
  frame.anyBehind = frame.drawsAny([&] { frame.drawStarts(p); }) || frame.anyBehind;
  target.drawn = surface.drawn;
}

void castGroup(FrameState& frame) {
  if (!frame.layer.empty()) {
    castBehind(frame);
    return;
  }
  Target& target = castTarget(frame);
  if (!frame.onlyWaiting || frame.groupIsEmpty()) clearHits(frame, target);
  if (frame.groupIsEmpty()) return;
  frame.begin(target);
  Program& p = castProgram(frame, frame.onlyWaiting ? Rays::again : Rays::all);
  if (frame.onlyWaiting) {  // each pixel reads only what it wrote itself
    frame.gl->TextureBarrier();
    p.setTexture("uBefore", 4, target.images.back());
  }
  frame.drawStarts(p);
  target.drawn = frame.rayStarts().area();
}

void castRays(FrameState& frame) {
  if (frame.onProcessor.casts)
    castOnProcessor(frame);
  else
    frame.forGroups([&] { castGroup(frame); });
}

void declareRefine(Declaring& d) {
  if (d.asked.scene.hit.method == scene::HitMethod::exact) {
    d.writes("refined points").notNeeded("exact hits are solved in their cells");
    return;
  }
  readsOfGroups(d, image::bracket);
  writesOfGroups(d, image::surface, 24);
  d.volume().isovalues().pictureSize().settings({"camera.", "hit.field", "hit.refinements"});
}

void refineGroup(FrameState& frame) {
  Target& target = surfaceTargetNamed(frame, frame.castName(image::surface));
  // In bricks, what was refined in an earlier round of the frame stays.
  if (frame.groupIsEmpty() || (frame.bricks() && !frame.keepHits)) frame.clear(target, {kNoSurface, kZero});
  if (frame.groupIsEmpty()) return;
  const scene::Field field = frame.scene->hit.field;
  Program& p = frame.program("refine.frag.glsl", field == scene::Field::trilinear ? "" : "#define CUBIC\n");
  frame.setView(p);
  frame.volume->bind(p, {field});
  frame.setIsovalues(p, field);
  p.setTexture("uBrackets", 2, frame.image(frame.castName(image::bracket)));
  p.set("uRefinements", frame.scene->hit.refinements);
  frame.drawHits(target, p, frame.images.at(frame.castName(image::bracket) + frame.layer).drawn);
}

void refineHits(FrameState& frame) {
  frame.forGroups([&] { refineGroup(frame); });
}

void declareMerge(Declaring& d) {
  if (d.asked.groups() == 1) {
    d.writes("merged points").notNeeded("one cast follows up to four isosurfaces");
    return;
  }
  readsOfGroups(d, image::surface);
  d.writes(image::surface, 24);
}

void setMerged(FrameState& frame, Program& p, const Target& target, const Target& of) {
  frame.gl->TextureBarrier();  // each pixel reads only what it wrote itself
  p.setTexture("uNearest", 0, target.images[0]);
  p.setTexture("uWaiting", 1, target.images[1]);
  p.setTexture("uSurface", 2, of.images[0]);
  p.setTexture("uInfo", 3, of.images[1]);
}

// Marks where the ray leaves a solid of labels and enters another that touches it.
void joinSolids(FrameState& frame, const Target& target) {
  Program& p = frame.program("merge.frag.glsl", "#define JOIN\n");
  frame.setView(p);
  p.set("uOutward", static_cast<float>(frame.outward()));
  const auto join = [&](const Target& of) {
    setMerged(frame, p, target, of);
    frame.drawRectangles(p, target.drawn.rectangles());
  };
  frame.forGroups([&] { join(frame.images.at(frame.castName(image::surface) + frame.layer)); });
  if (!frame.layer.empty()) join(frame.images.at(image::surface + frame.layerBefore));
}

void mergeGroups(FrameState& frame) {
  if (frame.onProcessor.casts) return mergeOnProcessor(frame);
  Target& target = surfaceTarget(frame);
  frame.clear(target, {kNoSurface, kZero});
  if (frame.empty()) return;
  Program& p = frame.program("merge.frag.glsl");
  volume::PictureArea drawn(frame.raySize());
  frame.begin(target);
  frame.forGroups([&] {
    const Target& of = frame.images.at(frame.castName(image::surface) + frame.layer);
    setMerged(frame, p, target, of);
    p.set("uFirst", static_cast<int>(frame.firstSurface()));
    frame.drawRectangles(p, of.drawn.rectangles());
    drawn.add(of.drawn);
  });
  target.drawn = drawn;
  if (frame.joinsSolids()) joinSolids(frame, target);
}

void setHidden(FrameState& frame, Program& p) {
  frame.volume->surface().bindHidden(p, 14, frame.placeInVolume());
  if (frame.scene->hit.field == scene::Field::trilinear) return;
  const auto texel = [&](const Surface& surface) { return frame.volume->texelOf(surface.value); };
  p.set("uSampleIsovalues", frame.ofGroupSurfaces(texel));
}

void setCut(const FrameState& frame, Program& p) {
  const auto faces = frame.cut.region().faces();
  for (std::size_t i = 0; i < faces.size(); ++i)
    p.set(("uClip[" + std::to_string(i) + "]").c_str(), glm::vec4(faces[i]));
  const auto removed = frame.cut.region().removed();
  for (std::size_t i = 0; i < removed.size(); ++i) {
    p.set(("uRemovedLow[" + std::to_string(i) + "]").c_str(), glm::vec3(removed[i].low));
    p.set(("uRemovedHigh[" + std::to_string(i) + "]").c_str(), glm::vec3(removed[i].high));
  }
  if (!removed.empty()) p.set("uRemovedAxes", glm::mat3(frame.cut.region().axes()));
  p.set("uClipped", frame.clippedBits());
}

}  // namespace

PassList hitPasses() {
  const Pass::Kind casts{.castsRays = true, .ofCrossing = true}, atHits{.atHits = true, .ofCrossing = true};
  return {
      // Finds the active blocks of the isovalues, and which of their sub-blocks can contain a surface.
      {.name = "blocks", .declare = declareBlocks, .run = findBlocks, .bytes = bytesOfBlocks},
      // Finds the depths between which the rays of each tile can meet anything, by projecting the active
      // blocks.
      {.name = "segments", .declare = declareSegments, .run = findSegments, .bytes = bytesOfSegments},
      // Uploads the bricks that the rays of the previous frame requested; does nothing for a volume in one
      // texture.
      {.name = pass::bricks, .declare = declareBricks, .run = uploadBricks, .bytes = bytesOfBricks},
      cutFacesPass(),
      // Finds the first crossing of an isovalue on each ray: exact hits are the surface points, sampled ones
      // still a bracket [t0, t1]. In a layer, finds the crossing behind that of the previous layer; pixels
      // without one are unchanged.
      {pass::cast, declareCast, castRays, {}, casts, Pass::Cpu::casts},
      // Refines a sampled hit to a surface point, by narrowing its bracket on the exact field of hit.field.
      {pass::refine, declareRefine, refineHits, {}, atHits},
      // Takes the nearest crossing of each ray, where more surfaces are shown than one cast follows.
      {pass::merge, declareMerge, mergeGroups, {}, atHits, Pass::Cpu::casts},
  };
}

void readsOfGroups(Declaring& d, const char* image) {
  const std::size_t groups = d.asked.groups();
  for (std::size_t group = 0; group < groups; ++group) d.reads(ofGroup(image, group, groups));
}

Target& surfaceTarget(FrameState& frame) {
  return surfaceTargetNamed(frame, image::surface);
}

bool anyHit(FrameState& frame) {
  if (frame.empty()) return false;
  if (frame.onProcessor.casts) return !frame.area().empty();
  const Gl& gl = *frame.gl;
  frame.begin(frame.images.at(image::surface));  // nothing is written there
  Program& p = frame.program("any_hit.frag.glsl", "#define TILES\n");
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  bool any = false;
  frame.forVolumes([&] {
    frame.rayStarts().bind(p, 2);
    p.setTexture("uSurface", 0, frame.image(image::surface));
    any = any || frame.drawsAny([&] { frame.drawStarts(p); });
  });
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return any;
}

std::string traceDefines(const FrameState& frame) {
  const scene::Hit& hit = frame.scene->hit;
  std::string defines = "#define SURFACES " + std::to_string(frame.groupSurfaces().size()) + "\n";
  if (hit.method == scene::HitMethod::exact) defines += "#define EXACT\n";
  if (hit.field != scene::Field::trilinear) defines += "#define CUBIC\n";
  if (!frame.volume->hidden().empty()) defines += "#define HIDDEN\n";
  const volume::ClipRegion& region = frame.cut.region();
  if (region.cuts()) defines += "#define CLIP " + std::to_string(region.faces().size()) + "\n";
  if (!region.removed().empty())
    defines += "#define REMOVED " + std::to_string(region.removed().size()) + "\n";
  return defines;
}

void setTrace(FrameState& frame, Program& p) {
  const scene::Field field = frame.scene->hit.field;
  frame.setView(p);
  frame.volume->bind(p, {field});
  frame.setIsovalues(p, field);
  frame.volume->surface().bindMasks(p, frame.scene->hit, 3);
  if (!frame.volume->hidden().empty()) setHidden(frame, p);
  if (frame.cut.cuts()) setCut(frame, p);
  p.set("uGaps", frame.volume->grid().missingCount() > 0 ? 1 : 0);
}

}  // namespace isolux::render
