#include "render/passes/hit_passes.h"

#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include "render/passes/block_area.h"

namespace isolux::render {

namespace {

constexpr float kNever = 1e30f;
constexpr float kNoBracket[4] = {1.0f, 0.0f, 0.0f, 0.0f};
constexpr float kNoSurface[4] = {0.0f, 0.0f, 0.0f, -1.0f};

// An eye inside an active block sees no face where its rays start: they start at the eye.
bool eyeInActiveBlock(const FrameState& frame) {
  const volume::MinMaxBlocks& blocks = frame.volume->blocks();
  const glm::ivec3 dims = frame.volume->grid().dims();
  const glm::dvec3 last(dims - 1), eye = frame.view->eyeVoxel;
  constexpr double margin = 0.1;  // voxels: an eye on a face counts as inside
  if (!glm::all(glm::greaterThan(eye, glm::dvec3(-margin))) || !glm::all(glm::lessThan(eye, last + margin)))
    return false;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 offset((corner & 1) ? margin : -margin, (corner & 2) ? margin : -margin,
                            (corner & 4) ? margin : -margin);
    const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(eye + offset)), glm::ivec3(0), dims - 2);
    if (frame.volume->isActive(blocks.index(cell / blocks.blockCells()))) return true;
  }
  return false;
}

bool isExact(const FrameState& frame) {
  return frame.scene->hit.method == scene::HitMethod::exact;
}

// Exact hits are the surface points themselves; sampled ones are brackets yet.
Target& castTarget(FrameState& frame) {
  return isExact(frame) ? frame.target(image::surface, {GL_RGBA32F, GL_RG32F})
                        : frame.target(image::bracket, {GL_RGBA32F});
}

void clearHits(const FrameState& frame, Target& target) {
  if (isExact(frame))
    frame.clear(target, {kNoSurface, kZero});
  else
    frame.clear(target, {kNoBracket});
}

}  // namespace

void BlocksPass::declare(Declaring& d) const {
  d.volume().isovalues().settings({"hit.field"}).input("graphics copy of the volume", d.asked.volume.made);
  d.writes(image::activeBlocks).writes(image::faces);
}

void BlocksPass::run(FrameState& frame) {
  if (!frame.volume) return;
  std::vector<double> values;
  for (const Surface& surface : frame.surfaces) values.push_back(surface.value);
  frame.volume->activate(frame.scene->hit.field, values);
}

std::optional<std::size_t> BlocksPass::bytes(const FrameState& frame) const {
  return frame.volume ? frame.volume->blockBytes() : 0;
}

void SegmentsPass::declare(Declaring& d) const {
  if (d.asked.onProcessor.casts) {
    d.writes(image::segments).notNeeded("the processor casts the rays");
    return;
  }
  d.reads(image::activeBlocks).reads(image::faces).writes(image::segments);
  d.settings({"camera."}).pictureSize();
}

SegmentsPass::Faces::Faces(const GlPtr& gl, const char* shader)
    : array(gl), program(gl, "faces.vert.glsl", shader) {
  gl->EnableVertexArrayAttrib(array.id(), 0);
  gl->VertexArrayAttribIFormat(array.id(), 0, 1, GL_UNSIGNED_INT, 0);
  gl->VertexArrayAttribBinding(array.id(), 0, 0);
  gl->VertexArrayBindingDivisor(array.id(), 0, 1);
}

void SegmentsPass::run(FrameState& frame) {
  Target& target = frame.target(image::segments, {GL_R32F});
  frame.begin(target);
  const bool atEye = !frame.empty() && !frame.view->orthographic && eyeInActiveBlock(frame);
  const float before[4] = {atEye ? 0.0f : kNever, 0.0f, 0.0f, 0.0f};
  frame.clear(target, {before});
  if (frame.empty()) return;
  if (!faces_) faces_.emplace(frame.gl, shader);
  const Gl& gl = *frame.gl;
  Program& p = faces_->program;
  frame.setView(p);
  const glm::dmat3 voxelFromCamera(frame.view->rightVoxel, frame.view->upVoxel, frame.view->forwardVoxel);
  p.set("uCameraFromVoxel", glm::mat3(glm::inverse(voxelFromCamera)));
  p.set("uBlockCells", frame.volume->blocks().blockCells());
  p.set("uDims", frame.volume->grid().dims());
  const glm::dvec2 whole(frame.request.size), part(frame.drawnSize());
  p.set("uTileScale", glm::vec2(whole / part));
  p.set("uTileShift", glm::vec2((whole - 2.0 * glm::dvec2(frame.tileOrigin())) / part - 1.0));
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MIN);
  gl.UseProgram(p.id());
  const GLuint array = faces_->array.id();
  gl.VertexArrayVertexBuffer(array, 0, frame.volume->faceBuffer().id(), 0, sizeof(PackedFace));
  gl.BindVertexArray(array);
  gl.DrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(frame.volume->faceCount()));
  gl.Disable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
}

void BricksPass::declare(Declaring& d) const {
  d.writes(image::bricks);
  d.notNeeded(d.asked.onProcessor.all ? "nothing on the graphics card reads voxels"
                                      : "the volume is one texture");
  d.volume().input("graphics copy of the volume", d.asked.volume.made);
  if (!d.asked.bricks.inUse) return;
  d.input("graphics memory", d.asked.bricks.made).input("what rays ask for", d.asked.bricks.asked);
}

void BricksPass::run(FrameState& frame) {
  Bricks& bricks = *frame.volume->bricks();
  if (frame.request.brickUploadBytes > 0) bricks.serve(bricks.frameRound(), frame.request.brickUploadBytes);
}

std::optional<std::size_t> BricksPass::bytes(const FrameState& frame) const {
  return frame.volume && frame.volume->bricks() ? frame.volume->bricks()->bytes() : 0;
}

void CastPass::declare(Declaring& d) const {
  const bool exact = d.asked.scene.hit.method == scene::HitMethod::exact;
  d.reads(image::activeBlocks).writes(exact ? image::surface : image::bracket);
  d.volume().isovalues().pictureSize().settings({"camera.", "hit."}, {"hit.refinements"});
  d.input("executor", d.asked.onProcessor.casts);
  if (d.asked.onProcessor.casts) return;
  d.reads(image::segments);
  d.input("volume in bricks", d.asked.bricks.inUse);
  if (d.asked.bricks.inUse) d.reads(image::bricks);
}

Program& CastPass::program(FrameState& frame, Rays rays) const {
  const scene::Hit& hit = frame.scene->hit;
  std::string defines = "#define SURFACES " + std::to_string(frame.surfaces.size()) + "\n";
  if (isExact(frame)) defines += "#define EXACT\n";
  if (hit.field != scene::Field::trilinear) defines += "#define CUBIC\n";
  if (rays == Rays::behind) defines += "#define BEHIND\n";
  if (rays == Rays::again) defines += "#define AGAIN\n";
  Program& p = frame.program(shader, defines);
  setTrace(frame, p);
  p.setTexture("uSegments", 2, frame.images.at(image::segments).images[0]);
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

void CastPass::run(FrameState& frame) {
  if (frame.onProcessor.casts) {
    castOnProcessor(frame);
    if (!frame.layer.empty()) frame.anyBehind = !frame.area().empty();
    return;
  }
  if (!frame.layer.empty()) {
    castBehind(frame);
    return;
  }
  Target& target = castTarget(frame);
  if (frame.empty()) {
    clearHits(frame, target);
    return;
  }
  Program& p = program(frame, frame.onlyWaiting ? Rays::again : Rays::all);
  if (frame.onlyWaiting) {  // each pixel reads only what it wrote itself
    frame.gl->TextureBarrier();
    p.setTexture("uBefore", 4, target.images.back());
  }
  frame.drawHits(target, p, blockArea(frame));
}

void CastPass::castBehind(FrameState& frame) const {
  Target& target = castTarget(frame);
  frame.begin(target);
  clearHits(frame, target);
  Program& p = program(frame, Rays::behind);
  const Target& surface = frame.images.at(image::surface + frame.layerBefore);
  p.setTexture("uSurface", 4, surface.images[0]);
  p.setTexture("uInfo", 5, surface.images[1]);
  p.setTexture("uColor", 6, frame.images.at(image::color).images[0]);
  frame.anyBehind = frame.drawsAny(p, surface.drawn);
  target.drawn = surface.drawn;
}

void RefinePass::declare(Declaring& d) const {
  if (d.asked.scene.hit.method == scene::HitMethod::exact) {
    d.writes("refined points").notNeeded("exact hits are solved in their cells");
    return;
  }
  d.reads(image::bracket).writes(image::surface);
  d.volume().isovalues().pictureSize().settings({"camera.", "hit.field", "hit.refinements"});
}

void RefinePass::run(FrameState& frame) {
  Target& target = frame.target(image::surface, {GL_RGBA32F, GL_RG32F});
  // In bricks, what was refined in an earlier round of the frame stays.
  if (frame.empty() || (frame.bricks() && !frame.keepHits)) frame.clear(target, {kNoSurface, kZero});
  if (frame.empty()) return;
  const scene::Field field = frame.scene->hit.field;
  Program& p = frame.program(shader, field == scene::Field::trilinear ? "" : "#define CUBIC\n");
  frame.setView(p);
  frame.volume->bind(p, field);
  frame.setIsovalues(p, field);
  p.setTexture("uBrackets", 2, frame.image(image::bracket));
  p.set("uRefinements", frame.scene->hit.refinements);
  frame.drawHits(target, p, frame.images.at(image::bracket + frame.layer).drawn);
}

bool anyHit(FrameState& frame) {
  if (frame.empty()) return false;
  if (frame.onProcessor.casts) return !frame.area().empty();
  const Gl& gl = *frame.gl;
  frame.begin(frame.images.at(image::segments));  // nothing is written there
  Program& p = frame.program("any_hit.frag.glsl");
  p.setTexture("uSurface", 0, frame.image(image::surface));
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  const bool any = frame.drawsAny(p, frame.area());
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return any;
}

void setTrace(FrameState& frame, Program& p) {
  const scene::Field field = frame.scene->hit.field;
  frame.setView(p);
  frame.volume->bind(p, field);
  frame.setIsovalues(p, field);
  p.setTexture("uBlockMasks", 3, frame.volume->maskTexture());
  p.set("uGaps", frame.volume->grid().missingCount() > 0 ? 1 : 0);
  p.set("uBlockShift", std::countr_zero(static_cast<unsigned>(frame.volume->blocks().blockCells())));
}

}  // namespace isolux::render
