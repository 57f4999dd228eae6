#include "render/passes/frame_state.h"

#include <algorithm>
#include <chrono>

#include <glm/geometric.hpp>

#include "base/clock.h"
#include "render/passes/cut_faces_pass.h"
#include "render/passes/light_passes.h"
#include "render/passes/passes.h"
#include "scene/albedo.h"
#include "scene/shown_surfaces.h"
#include "volume/edge/surface_edges.h"
#include "volume/field/curvature.h"

namespace isolux::render {

namespace {
// Rows of a picture that are drawn between two looks at a stop, and how long they should take, ms. Multiples
// of the squares that llvmpipe works in.
constexpr int kBandRows = 64, kMostBandGrowth = 4;
constexpr double kBandMilliseconds = 6.0;

// As many rows as should take the wanted time, when `rows` took `milliseconds`.
int nextBand(int rows, double milliseconds) {
  const double wanted = rows * kBandMilliseconds / std::max(milliseconds, 0.01);
  const int bands =
      static_cast<int>(std::min(wanted, static_cast<double>(kMostBandGrowth) * rows)) / kBandRows;
  return std::max(1, bands) * kBandRows;
}

template <class Holds>
int bitsOf(std::span<const Surface> surfaces, const Holds& holds) {
  int bits = 0;
  for (int k = 0; const Surface& surface : surfaces) bits |= static_cast<int>(holds(surface)) << k++;
  return bits;
}
}  // namespace

std::vector<Surface> surfacesOf(const scene::Scene& scene) {
  std::vector<Surface> surfaces;
  for (const auto& s : scene::visibleSurfaces(scene))
    surfaces.push_back({s.value.value(), s.albedo, s.opacity, s.facingOpacity, s.clipped, s.specular,
                        s.roughness, s.labelColors});
  if (scene.isosurface.albedoSource == scene::AlbedoSource::map) {
    const scene::AlbedoOfIsovalue albedo(scene);
    for (Surface& surface : surfaces) surface.albedo = albedo.at(surface.value);
  }
  return surfaces;
}

std::vector<double> valuesOf(std::span<const Surface> surfaces) {
  std::vector<double> values;
  for (const Surface& surface : surfaces) values.push_back(surface.value);
  return values;
}

std::size_t placesOf(std::size_t surfaces) {
  return kGroupSurfaces * std::max<std::size_t>(1, (surfaces + kGroupSurfaces - 1) / kGroupSurfaces);
}

std::string ofGroup(const char* image, std::size_t group, std::size_t groups) {
  return groups == 1 ? image : std::string(image) + " of group " + std::to_string(group + 1);
}

FrameState::FrameState(GlPtr pointer)
    : gl(std::move(pointer)),
      lighting(std::make_unique<FrameLight>(gl)),
      lookTextures(std::make_unique<LookTextures>()),
      emptyArray_(gl),
      anySamples_(gl, GL_ANY_SAMPLES_PASSED),
      samples_(gl, GL_SAMPLES_PASSED) {}

FrameState::~FrameState() = default;

Program& FrameState::program(const std::string& fragment, const std::string& defines) {
  const Bricks* const inBricks = bricks();
  const std::string all = inBricks ? "#define BRICKS\n#define BRICK_APRON " +
                                         std::to_string(inBricks->apron()) + "\n" +
                                         (inBricks->mayLoseBlocks() ? "#define LOST_BLOCKS\n" : "") + defines
                                   : defines;
  const std::string key = fragment + "|" + all;
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  return programs_.emplace(key, Program(gl, "fullscreen.vert.glsl", fragment, all)).first->second;
}

void FrameState::begin(const Target& target) const {
  begin(target, glm::ivec2(target.images[0].size()));
}

void FrameState::begin(const Target& target, glm::ivec2 size) const {
  gl->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  gl->Viewport(0, 0, size.x, size.y);
  drawing_ = size;
}

void FrameState::clear(Target& target, std::initializer_list<const float*> values) const {
  const float* const* value = values.begin();
  for (GLint image = 0; image < target.framebuffer.colors(); ++image) {
    gl->ClearNamedFramebufferfv(target.framebuffer.id(), GL_COLOR, image, *value);
    if (value + 1 != values.end()) ++value;
  }
  target.drawn = volume::PictureArea(glm::ivec2(target.images[0].size()));
}

void FrameState::drawFullscreen(const Program& program) const {
  drawRectangles(program, {{glm::ivec2(0), drawing_}});
}

// Parts of one triangle: two for each rectangle would shade the pixels along its diagonal twice.
void FrameState::drawRectangles(const Program& program,
                                const std::vector<volume::Rectangle>& rectangles) const {
  gl->UseProgram(program.id());
  gl->BindVertexArray(emptyArray_.id());
  drawParts(program, rectangles, [this] { gl->DrawArrays(GL_TRIANGLES, 0, 3); });
}

void FrameState::drawStarts(const Program& program) const {
  gl->UseProgram(program.id());
  drawParts(program, {{glm::ivec2(0), drawing_}}, [this] { rayStarts().draw(); });
}

void FrameState::drawParts(const Program& program, const Parts& parts,
                           const std::function<void()>& draw) const {
  gl->Enable(GL_SCISSOR_TEST);
  const bool inBricks = volume && !onProcessor.all && volume->bricks();  // their rounds are drawn to the end
  const bool timed = !gl->software && gl->timestampBits > 0;
  if (!timed && request.stop.stop_possible() && !inBricks) {
    drawInBands(parts, draw);
  } else {
    Parts drawn = parts;
    if (raysOfRound)
      for (volume::Rectangle& one : drawn) one = volume::common(one, *raysOfRound);
    if (timed)
      drawTimed(program, drawn, draw);
    else
      for (const volume::Rectangle& one : drawn) drawPart(one, draw);
  }
  gl->Disable(GL_SCISSOR_TEST);
}

void FrameState::drawTimed(const Program& program, const Parts& parts,
                           const std::function<void()>& draw) const {
  const bool inBricks = volume && !onProcessor.all && volume->bricks();
  PartTimer& timer = timers_.try_emplace(program.id(), gl).first->second;
  PartCutter rest(parts);
  timer.beginDraw();
  while (!rest.done() && (inBricks || !request.stop.stop_requested())) {
    const int rays = timer.beginPart();
    const Parts part = rest.next(rays);
    for (const volume::Rectangle& one : part) drawPart(one, draw);
    timer.endPart(raysOf(part));
  }
  timer.endDraw();
}

void FrameState::drawPart(const volume::Rectangle& part, const std::function<void()>& draw) const {
  if (part.size.x == 0 || part.size.y == 0) return;
  gl->Scissor(part.low.x, part.low.y, part.size.x, part.size.y);
  draw();
}

void FrameState::drawInBands(const Parts& parts, const std::function<void()>& draw) const {
  using Clock = std::chrono::steady_clock;
  int rows = kBandRows, drawn = 0;  // of the band
  Clock::time_point begin = Clock::now();
  for (const volume::Rectangle& one : parts)
    for (int row = 0; row < one.size.y;) {
      const int now = std::min(rows - drawn, one.size.y - row);
      drawPart({one.low + glm::ivec2(0, row), {one.size.x, now}}, draw);
      row += now;
      drawn += now;
      if (drawn < rows) continue;
      gl->Finish();
      if (request.stop.stop_requested()) return;
      rows = nextBand(rows, 1000.0 * base::secondsSince(begin));
      drawn = 0;
      begin = Clock::now();
    }
}

void FrameState::copy(const Target& from, Target& to) const {
  volume::PictureArea drawn = from.drawn;
  drawn.add(to.drawn);
  for (const volume::Rectangle& part : drawn.rectangles()) {
    const glm::ivec2 low = part.low, high = part.low + part.size;
    gl->BlitNamedFramebuffer(from.framebuffer.id(), to.framebuffer.id(), low.x, low.y, high.x, high.y, low.x,
                             low.y, high.x, high.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  to.drawn = from.drawn;
}

void FrameState::drawHits(Target& target, const Program& program, const volume::PictureArea& of) const {
  volume::PictureArea drawn = of;
  drawn.add(target.drawn);
  begin(target);
  drawRectangles(program, drawn.rectangles());
  target.drawn = request.stop.stop_requested() ? drawn : of;
}

std::size_t FrameState::groups() const {
  return isOfLabels() ? volumes.size() : placesOf(surfaces.size()) / kGroupSurfaces;
}

void FrameState::takeGroup(std::size_t which) {
  group = which;
  volume = volumes.empty() ? nullptr : volumes[isOfLabels() ? which : 0].get();
}

std::span<const Surface> FrameState::groupSurfaces() const {
  if (isOfLabels()) return std::span(surfaces).subspan(group, 1);
  const std::size_t first = firstSurface();
  return std::span(surfaces).subspan(first, std::min(kGroupSurfaces, surfaces.size() - first));
}

void FrameState::setVolumeHits(Program& program, int unit) const {
  if (!isOfLabels()) return;
  program.setTexture("uGroupInfo", unit, image(image::surface, 1));
  program.set("uGroupSurface", static_cast<int>(firstSurface()));
}

std::string FrameState::surfaceDefines() const {
  if (groups() == 1) return {};
  return "#define ALL_SURFACES " + std::to_string(placesOf(surfaces.size())) + "\n";
}

int FrameState::clippedBits() const {
  return bitsOf(groupSurfaces(), [](const Surface& surface) { return surface.clipped; });
}

int FrameState::opaqueBits() const {
  return bitsOf(groupSurfaces(), [](const Surface& surface) { return surface.opaque(); });
}

std::vector<volume::Rectangle> FrameState::surfacePixels() const {
  volume::PictureArea drawn = images.at(image::color).drawn;
  if (cutFaceColors) drawn.add(images.at(image::cutFaces).drawn);
  std::vector<volume::Rectangle> parts = drawn.rectangles();
  for (volume::Rectangle& part : parts) {
    part.low += raysLow() + glm::ivec2(0, bandRow);
    const glm::ivec2 end = (part.low + part.size + (request.supersampling - 1)) / request.supersampling;
    part.low /= request.supersampling;
    part.size = end - part.low;
  }
  return parts;
}

bool FrameState::drawsAny(const std::function<void()>& draw) {
  gl->BeginQuery(GL_ANY_SAMPLES_PASSED, anySamples_.id());
  draw();
  gl->EndQuery(GL_ANY_SAMPLES_PASSED);
  return anySamples_.result() != 0;
}

std::int64_t FrameState::samplesOf(const std::function<void()>& draw) {
  gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl->BeginQuery(GL_SAMPLES_PASSED, samples_.id());
  draw();
  gl->EndQuery(GL_SAMPLES_PASSED);
  gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return static_cast<std::int64_t>(samples_.result());
}

void FrameState::setView(Program& program) const {
  program.set("uEyeVoxel", glm::vec3(view->eyeVoxel));
  program.set("uRightVoxel", glm::vec3(view->rightVoxel));
  program.set("uUpVoxel", glm::vec3(view->upVoxel));
  program.set("uForwardVoxel", glm::vec3(view->forwardVoxel));
  program.set("uHalfExtent", glm::vec2(view->halfExtent));
  program.set("uOrthographic", view->orthographic ? 1 : 0);
  program.set("uPictureSize", request.size * request.supersampling);
  program.set("uStartDepth", static_cast<float>(view->startDepth));
  program.set("uTileOrigin", rayOrigin());
  program.set("uFirstRow", 0);
}

void FrameState::setPoint(Program& program, int unit) const {
  program.setTexture("uSurface", unit, image(image::surface, 0));
  program.set("uGradientRow", 0);
  // Not of a look without normals: it may be freed.
  if (images.has((gradientShared ? image::tangents : image::gradient) + layer))
    program.setTexture("uGradient", unit + 1, gradientImage());
  program.setTexture("uInfo", unit + 2, image(image::surface, 1));
  program.set("uRightWorld", glm::vec3(view->rightWorld));
  program.set("uUpWorld", glm::vec3(view->upWorld));
  program.set("uForwardWorld", glm::vec3(view->forwardWorld));
  program.set("uOutward", static_cast<float>(outward()));
  program.set("uWorldFromVoxel", glm::mat3(volume->grid().geometry().worldFromVoxel));
}

glm::dvec3 FrameState::towardLight() const {
  const glm::dvec3 given = scene->light.direction;
  const bool inCamera = scene->light.space == scene::LightSpace::camera;
  if (!(glm::length(given) > 0.0)) return -view->forwardWorld;
  const glm::dvec3 d = glm::normalize(given);
  return inCamera ? d.x * view->rightWorld + d.y * view->upWorld - d.z * view->forwardWorld : d;
}

double FrameState::flatCurvature() const {
  const volume::GridGeometry& geometry = volume->grid().geometry();
  return volume::curvatureScale(geometry, scene->derivatives.field, 0.0).flatCurvature;
}

void FrameState::setIsovalues(Program& program, scene::Field field) const {
  const auto texel = [&](const Surface& surface) { return volume->texelOf(surface.value, field); };
  const double first = texel(groupSurfaces().front());
  program.set("uIsovalues", ofGroupSurfaces(texel));
  program.set("uIsovalueShifts", ofGroupSurfaces([&](const Surface& own) { return texel(own) - first; }));
}

FieldAt edgeFieldOf(const scene::Scene& scene) {
  const scene::Field field = scene.derivatives.field;
  return {field == scene::Field::trilinear ? scene::Field::cubic : field, scene::derivativesScale(scene)};
}

volume::EdgeSearch<double> FrameState::edgeSearch() const {
  const volume::Grid& grid = volume->grid();
  const FieldAt field = edgeField();
  return volume::edgeSearch(grid, field.field, field.scaleMm,
                            volume::edgeQuestion(*scene, grid.geometry(), volume->noiseBlur()));
}

}  // namespace isolux::render
