#include "render/passes/hit_passes.h"

#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

namespace isolux::render {

namespace {

constexpr float kNever = 1e30f;
constexpr float kNoBracket[4] = {1.0f, 0.0f, 0.0f, 0.0f};
constexpr float kNoSurface[4] = {0.0f, 0.0f, 0.0f, -1.0f};
constexpr float kZero[4] = {0.0f, 0.0f, 0.0f, 0.0f};

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

}  // namespace

HitPasses::HitPasses(const GlPtr& gl)
    : faceArray_(gl),
      segmentsProgram_(gl, "faces.vert.glsl", "segments.frag.glsl"),
      anyHit_(gl, GL_ANY_SAMPLES_PASSED) {
  gl->EnableVertexArrayAttrib(faceArray_.id(), 0);
  gl->VertexArrayAttribIFormat(faceArray_.id(), 0, 1, GL_UNSIGNED_INT, 0);
  gl->VertexArrayAttribBinding(faceArray_.id(), 0, 0);
  gl->VertexArrayBindingDivisor(faceArray_.id(), 0, 1);
}

void HitPasses::blocks(FrameState& frame) {
  if (!frame.volume) return;
  std::vector<double> values;
  for (const Surface& surface : frame.surfaces) values.push_back(surface.value);
  frame.volume->activate(frame.scene->hit.field, values);
}

void HitPasses::segments(FrameState& frame) {
  const Target& target = frame.target(pass::segments, {GL_R32F});
  frame.begin(target);
  const bool atEye = !frame.empty() && !frame.view->orthographic && eyeInActiveBlock(frame);
  frame.clear(target, 0, {atEye ? 0.0f : kNever, 0.0f, 0.0f, 0.0f});
  if (frame.empty()) return;
  const Gl& gl = *frame.gl;
  frame.setView(segmentsProgram_);
  const glm::dmat3 voxelFromCamera(frame.view->rightVoxel, frame.view->upVoxel, frame.view->forwardVoxel);
  segmentsProgram_.set("uCameraFromVoxel", glm::mat3(glm::inverse(voxelFromCamera)));
  segmentsProgram_.set("uBlockCells", frame.volume->blocks().blockCells());
  segmentsProgram_.set("uDims", frame.volume->grid().dims());
  const glm::dvec2 whole(frame.request.size), part(frame.drawnSize());
  segmentsProgram_.set("uTileScale", glm::vec2(whole / part));
  segmentsProgram_.set("uTileShift", glm::vec2((whole - 2.0 * glm::dvec2(frame.tileOrigin())) / part - 1.0));
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MIN);
  gl.UseProgram(segmentsProgram_.id());
  gl.VertexArrayVertexBuffer(faceArray_.id(), 0, frame.volume->faceBuffer().id(), 0, sizeof(PackedFace));
  gl.BindVertexArray(faceArray_.id());
  gl.DrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(frame.volume->faceCount()));
  gl.Disable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
}

void HitPasses::setTrace(FrameState& frame, Program& p) {
  const scene::Field field = frame.scene->hit.field;
  frame.setView(p);
  frame.volume->bind(p, field);
  frame.setIsovalues(p, field);
  p.setTexture("uBlockMasks", 3, frame.volume->maskTexture());
  p.set("uGaps", frame.volume->grid().missingCount() > 0 ? 1 : 0);
  p.set("uBlockShift", std::countr_zero(static_cast<unsigned>(frame.volume->blocks().blockCells())));
}

Program& HitPasses::castProgram(FrameState& frame, Rays rays) {
  const scene::Hit& hit = frame.scene->hit;
  const bool exact = hit.method == scene::HitMethod::exact;
  std::string defines = "#define SURFACES " + std::to_string(frame.surfaces.size()) + "\n";
  if (exact) defines += "#define EXACT\n";
  if (hit.field != scene::Field::trilinear) defines += "#define CUBIC\n";
  if (rays == Rays::behind) defines += "#define BEHIND\n";
  if (rays == Rays::again) defines += "#define AGAIN\n";
  Program& p = frame.program("cast.frag.glsl", defines);
  setTrace(frame, p);
  p.setTexture("uSegments", 2, frame.images.at(pass::segments).images[0]);
  if (!exact) {
    p.set("uStep", static_cast<float>(1.0 / hit.rate));
    p.set("uNearFactor", static_cast<float>(hit.nearFactor));
    p.set("uNearThreshold",
          static_cast<float>(*hit.nearThreshold / std::abs(frame.volume->dataUnitsPerTexel(hit.field))));
    const double diagonal = glm::length(glm::dvec3(frame.volume->grid().dims()));
    p.set("uMaxSteps", static_cast<int>(diagonal * (hit.rate * hit.nearFactor + 2.0) + 16.0));
  }
  return p;
}

// Exact hits are the surface points themselves; sampled ones are brackets yet.
const Target& HitPasses::castTarget(FrameState& frame) const {
  return frame.scene->hit.method == scene::HitMethod::exact
             ? frame.target(pass::refine, {GL_RGBA32F, GL_RG32F})
             : frame.target(pass::cast, {GL_RGBA32F});
}

void HitPasses::clearHits(const FrameState& frame, const Target& target) const {
  const bool exact = frame.scene->hit.method == scene::HitMethod::exact;
  frame.clear(target, 0, exact ? kNoSurface : kNoBracket);
  if (exact) frame.clear(target, 1, kZero);
}

void HitPasses::cast(FrameState& frame, bool again) {
  const Target& target = castTarget(frame);
  frame.begin(target);
  if (frame.empty()) {
    clearHits(frame, target);
    return;
  }
  Program& p = castProgram(frame, again ? Rays::again : Rays::all);
  if (again) {  // each pixel reads only what it wrote itself
    frame.gl->TextureBarrier();
    p.setTexture("uBefore", 4, target.images.back());
  }
  frame.drawFullscreen(p);
}

bool HitPasses::castBehind(FrameState& frame, const std::string& front) {
  const Target& target = castTarget(frame);
  frame.begin(target);
  clearHits(frame, target);
  Program& p = castProgram(frame, Rays::behind);
  const Target& surface = frame.images.at(pass::refine + front);
  p.setTexture("uSurface", 4, surface.images[0]);
  p.setTexture("uInfo", 5, surface.images[1]);
  p.setTexture("uColor", 6, frame.images.at(pass::layers).images[0]);
  const Gl& gl = *frame.gl;
  gl.BeginQuery(GL_ANY_SAMPLES_PASSED, anyHit_.id());
  frame.drawFullscreen(p);
  gl.EndQuery(GL_ANY_SAMPLES_PASSED);
  GLuint64 any = 0;
  gl.GetQueryObjectui64v(anyHit_.id(), GL_QUERY_RESULT, &any);
  return any != 0;
}

bool HitPasses::anyHit(FrameState& frame) {
  if (frame.empty()) return false;
  const Gl& gl = *frame.gl;
  frame.begin(frame.images.at(pass::segments));  // nothing is written there
  Program& p = frame.program("any_hit.frag.glsl");
  p.setTexture("uSurface", 0, frame.image(pass::refine));
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.BeginQuery(GL_ANY_SAMPLES_PASSED, anyHit_.id());
  frame.drawFullscreen(p);
  gl.EndQuery(GL_ANY_SAMPLES_PASSED);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  GLuint64 any = 0;
  gl.GetQueryObjectui64v(anyHit_.id(), GL_QUERY_RESULT, &any);
  return any != 0;
}

void HitPasses::refine(FrameState& frame) {
  const Target& target = frame.target(pass::refine, {GL_RGBA32F, GL_RG32F});
  frame.begin(target);
  if (!frame.keepHits) {
    frame.clear(target, 0, kNoSurface);
    frame.clear(target, 1, kZero);
  }
  if (frame.empty()) return;
  const scene::Field field = frame.scene->hit.field;
  Program& p = frame.program("refine.frag.glsl", field == scene::Field::trilinear ? "" : "#define CUBIC\n");
  frame.setView(p);
  frame.volume->bind(p, field);
  frame.setIsovalues(p, field);
  p.setTexture("uBrackets", 2, frame.image(pass::cast));
  p.set("uRefinements", frame.scene->hit.refinements);
  frame.drawFullscreen(p);
}

}  // namespace isolux::render
