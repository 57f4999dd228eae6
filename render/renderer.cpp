#include "render/renderer.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/block_faces.h"
#include "render/gl_objects.h"
#include "render/passes.h"
#include "render/view_uniforms.h"
#include "render/volume_texture.h"
#include "scene/error.h"
#include "volume/reconstruct.h"

namespace isolux::render {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// An image of a pass and the framebuffer that draws into it.
struct Target {
  std::vector<Texture> images;
  Framebuffer framebuffer;
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const Texture& image : images) sum += image.bytes();
    return sum;
  }
};

Target makeTarget(const GlPtr& gl, glm::ivec2 size, std::initializer_list<GLenum> formats) {
  Target target;
  std::vector<const Texture*> colors;
  for (const GLenum format : formats) target.images.push_back(Texture::make2D(gl, format, size));
  for (const Texture& image : target.images) colors.push_back(&image);
  target.framebuffer = Framebuffer(gl, colors);
  return target;
}

}  // namespace

struct Renderer::Parts {
  explicit Parts(GlPtr pointer)
      : gl(std::move(pointer)),
        faceBuffer(gl),
        faceArray(gl),
        emptyArray(gl),
        segmentsProgram(gl, "faces.vert.glsl", "segments.frag.glsl"),
        resolveProgram(gl, "fullscreen.vert.glsl", "resolve.frag.glsl") {
    gl->EnableVertexArrayAttrib(faceArray.id(), 0);
    gl->VertexArrayAttribIFormat(faceArray.id(), 0, 1, GL_UNSIGNED_INT, 0);
    gl->VertexArrayAttribBinding(faceArray.id(), 0, 0);
    gl->VertexArrayBindingDivisor(faceArray.id(), 0, 1);
    gl->VertexArrayVertexBuffer(faceArray.id(), 0, faceBuffer.id(), 0, sizeof(PackedFace));
  }

  GlPtr gl;
  std::shared_ptr<const volume::PreparedVolume> volume;
  std::optional<VolumeTexture> volumeTexture, coefficients;
  FrameGraph graph;
  FrameReport report;

  // What the passes keep between frames.
  std::vector<std::uint8_t> activeFlags;
  std::size_t activeCount = 0, faceCount = 0;
  Texture activeTexture;
  Buffer faceBuffer;
  VertexArray faceArray, emptyArray;
  Target segments, bracket, surface, gradient, color, picture;
  glm::ivec2 raySize{0}, pictureSize{0};

  Program segmentsProgram, resolveProgram;
  std::map<std::string, Program> programs;  // by stage and defines

  // This frame.
  const scene::Scene* scene = nullptr;
  FrameRequest request;
  std::optional<ViewUniforms> view;
  double rayStartMm = 0.0;  // of the frame whose surface image is held
  double outward = -1.0;    // times the gradient: the outward normal of the last scene

  const volume::Grid& grid() const { return volume->grid(); }
  bool hasCells() const {
    return volume && glm::all(glm::greaterThan(volume->blocks->dims(), glm::ivec3(0)));
  }
  double storedIsovalue() const { return grid().storedOfValue(scene->isosurface.value.value()); }
  double dataUnitsPerTexel() const { return grid().slope() * volumeTexture->scale; }

  Program& program(const std::string& fragment, const std::string& defines);
  void upload(std::size_t budget);
  void allocate();
  void setView(Program& program);
  void setField(Program& program);
  void begin(const Target& target, glm::ivec2 size);
  void fullscreen(const Program& program);

  void runBlocks();
  void runSegments();
  void runCast();
  void runRefine();
  void runGradient();
  void runShade();
  void runResolve();
  std::size_t bytesOf(const std::string& pass) const;
};

Renderer::Renderer(std::shared_ptr<const Gl> gl) : parts_(std::make_unique<Parts>(std::move(gl))) {}
Renderer::~Renderer() = default;

void Renderer::setVolume(std::shared_ptr<const volume::PreparedVolume> volume) {
  if (volume == parts_->volume) return;
  parts_->volume = std::move(volume);
  parts_->volumeTexture.reset();
  parts_->coefficients.reset();
}

void Renderer::invalidate() {
  parts_->graph.invalidate();
}

Program& Renderer::Parts::program(const std::string& fragment, const std::string& defines) {
  const std::string key = fragment + "|" + defines;
  const auto found = programs.find(key);
  if (found != programs.end()) return found->second;
  return programs.emplace(key, Program(gl, "fullscreen.vert.glsl", fragment, defines)).first->second;
}

void Renderer::Parts::upload(std::size_t budget) {
  if (!hasCells()) return;
  const glm::ivec3 blocks = volume->blocks->dims();
  if (std::max({blocks.x, blocks.y, blocks.z}) > maxBlocksPerAxis)
    throw scene::Error(scene::ErrorKind::memory, volume->volume.name, "graphics memory",
                       "the volume has more than " + std::to_string(maxBlocksPerAxis) + " blocks on an axis");
  if (!volumeTexture) volumeTexture = uploadVolume(gl, grid(), budget);
  if (!coefficients && scene->derivatives.field == scene::Field::cubic_interpolating)
    coefficients = uploadCoefficients(gl, volume::interpolatingCoefficients(grid()), grid().dims(),
                                      budget - std::min(budget, volumeTexture->texture.bytes()));
}

// The size is a parameter of the passes that draw into these images, so a new image is always drawn anew.
void Renderer::Parts::allocate() {
  try {
    if (raySize != request.size * request.supersampling) {
      raySize = request.size * request.supersampling;
      segments = makeTarget(gl, raySize, {GL_RG32F});
      bracket = makeTarget(gl, raySize, {GL_RG32F});
      surface = makeTarget(gl, raySize, {GL_RGBA32F, GL_R32F});
      gradient = makeTarget(gl, raySize, {GL_RGBA32F});
      color = makeTarget(gl, raySize, {GL_RGBA16F});
    }
    if (pictureSize != request.size) {
      pictureSize = request.size;
      picture = makeTarget(gl, pictureSize, {GL_RGBA8});
    }
  } catch (...) {  // no room: nothing that was drawn is still there
    raySize = pictureSize = glm::ivec2(0);
    graph.invalidate();
    throw;
  }
}

void Renderer::Parts::setView(Program& p) {
  p.set("uEyeVoxel", glm::vec3(view->eyeVoxel));
  p.set("uRightVoxel", glm::vec3(view->rightVoxel));
  p.set("uUpVoxel", glm::vec3(view->upVoxel));
  p.set("uForwardVoxel", glm::vec3(view->forwardVoxel));
  p.set("uHalfExtent", glm::vec2(view->halfExtent));
  p.set("uOrthographic", view->orthographic ? 1 : 0);
  p.set("uPictureSize", raySize);
}

void Renderer::Parts::setField(Program& p) {
  p.setTexture("uVolume", 0, volumeTexture->texture);
  p.set("uDims", grid().dims());
  p.set("uIsovalue", static_cast<float>((storedIsovalue() - volumeTexture->offset) / volumeTexture->scale));
}

void Renderer::Parts::begin(const Target& target, glm::ivec2 size) {
  gl->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  gl->Viewport(0, 0, size.x, size.y);
}

void Renderer::Parts::fullscreen(const Program& p) {
  gl->UseProgram(p.id());
  gl->BindVertexArray(emptyArray.id());
  gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::Parts::runBlocks() {
  activeCount = faceCount = 0;
  if (!hasCells()) return;
  const volume::MinMaxBlocks& blocks = *volume->blocks;
  activeCount = blocks.activeBlocks(static_cast<float>(storedIsovalue()), activeFlags);
  const std::vector<PackedFace> faces = boundaryFaces(activeFlags, blocks.dims());
  faceCount = faces.size();
  faceBuffer.setData(faces.data(), faces.size() * sizeof(PackedFace));
  if (!activeTexture || activeTexture.size() != blocks.dims())
    activeTexture = Texture::make3D(gl, GL_R8, blocks.dims(), false);
  gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  // Flags are 0 or 1 of 255: the shader compares with 0.
  gl->TextureSubImage3D(activeTexture.id(), 0, 0, 0, 0, blocks.dims().x, blocks.dims().y, blocks.dims().z,
                        GL_RED, GL_UNSIGNED_BYTE, activeFlags.data());
}

void Renderer::Parts::runSegments() {
  begin(segments, raySize);
  constexpr float never = 1e30f;
  // An eye inside an active block sees no face where its rays start: they start at the eye.
  float start = never;
  if (faceCount > 0 && !view->orthographic) {
    const volume::MinMaxBlocks& blocks = *volume->blocks;
    const glm::dvec3 last(grid().dims() - 1), eye = view->eyeVoxel;
    constexpr double margin = 0.1;  // voxels: an eye on a face counts as inside
    if (glm::all(glm::greaterThan(eye, glm::dvec3(-margin))) && glm::all(glm::lessThan(eye, last + margin))) {
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 offset((corner & 1) ? margin : -margin, (corner & 2) ? margin : -margin,
                                (corner & 4) ? margin : -margin);
        const glm::ivec3 cell =
            glm::clamp(glm::ivec3(glm::floor(eye + offset)), glm::ivec3(0), grid().dims() - 2);
        if (activeFlags[blocks.index(cell / blocks.blockCells())]) start = 0.0f;
      }
    }
  }
  const float clear[4] = {start, never, 0.0f, 0.0f};
  gl->ClearNamedFramebufferfv(segments.framebuffer.id(), GL_COLOR, 0, clear);
  if (faceCount == 0) return;
  setView(segmentsProgram);
  segmentsProgram.set("uBlockCells", volume->blocks->blockCells());
  segmentsProgram.set("uDims", grid().dims());
  gl->Enable(GL_BLEND);
  gl->BlendEquation(GL_MIN);
  gl->UseProgram(segmentsProgram.id());
  gl->BindVertexArray(faceArray.id());
  gl->DrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(faceCount));
  gl->Disable(GL_BLEND);
  gl->BlendEquation(GL_FUNC_ADD);
}

void Renderer::Parts::runCast() {
  begin(bracket, raySize);
  if (faceCount == 0) {
    const float none[4] = {1.0f, 0.0f, 0.0f, 0.0f};
    gl->ClearNamedFramebufferfv(bracket.framebuffer.id(), GL_COLOR, 0, none);
    return;
  }
  const bool exact = scene->hit.method == scene::HitMethod::exact;
  Program& p = program("cast.frag.glsl", exact ? "#define EXACT\n" : "");
  setView(p);
  setField(p);
  p.setTexture("uSegments", 1, segments.images[0]);
  p.setTexture("uActiveBlocks", 2, activeTexture);
  p.set("uBlockShift", std::countr_zero(static_cast<unsigned>(volume->blocks->blockCells())));
  p.set("uStep", static_cast<float>(1.0 / scene->hit.rate));
  const glm::ivec3 n = grid().dims();
  const double diagonal = glm::length(glm::dvec3(n));
  p.set("uMaxSteps",
        static_cast<int>(exact ? 2.0 * (n.x + n.y + n.z) + 16.0 : diagonal * (scene->hit.rate + 2.0) + 16.0));
  fullscreen(p);
}

void Renderer::Parts::runRefine() {
  begin(surface, raySize);
  rayStartMm = view->rayStartMm;
  if (faceCount == 0) {
    const float none[4] = {0.0f, 0.0f, 0.0f, -1.0f};
    gl->ClearNamedFramebufferfv(surface.framebuffer.id(), GL_COLOR, 0, none);
    return;
  }
  Program& p = program("refine.frag.glsl", "");
  setView(p);
  setField(p);
  p.setTexture("uBrackets", 1, bracket.images[0]);
  p.set("uRefinements", scene->hit.refinements);
  fullscreen(p);
}

void Renderer::Parts::runGradient() {
  begin(gradient, raySize);
  const float none[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  gl->ClearNamedFramebufferfv(gradient.framebuffer.id(), GL_COLOR, 0, none);
  if (faceCount == 0) return;
  const bool cubic = scene->derivatives.field != scene::Field::trilinear;
  const bool interpolating = scene->derivatives.field == scene::Field::cubic_interpolating;
  const VolumeTexture& field = interpolating ? *coefficients : *volumeTexture;
  Program& p = program("gradient.frag.glsl", cubic ? "#define CUBIC\n" : "");
  setView(p);
  setField(p);
  p.setTexture("uSurface", 1, surface.images[0]);
  p.setTexture("uField", 2, field.texture);
  const glm::dmat3 transposedInverse =
      glm::transpose(glm::inverse(glm::dmat3(grid().geometry().worldFromVoxel))) * dataUnitsPerTexel();
  p.set("uWorldGradient", glm::mat3(transposedInverse));
  p.set("uFieldPerVolume", static_cast<float>(field.scale / volumeTexture->scale));
  fullscreen(p);
}

void Renderer::Parts::runShade() {
  begin(color, raySize);
  const scene::Look& look = scene->look;
  Program& p =
      program("shade.frag.glsl", "#define LOOK " + std::to_string(static_cast<int>(look.mode)) + "\n");
  setView(p);
  p.setTexture("uSurface", 1, surface.images[0]);
  p.setTexture("uGradient", 2, gradient.images[0]);
  p.set("uRightWorld", glm::vec3(view->rightWorld));
  p.set("uUpWorld", glm::vec3(view->upWorld));
  p.set("uForwardWorld", glm::vec3(view->forwardWorld));
  p.set("uOutward", static_cast<float>(outward));
  p.set("uAlbedo", glm::vec3(scene->isosurface.albedo));
  p.set("uAmbient", static_cast<float>(look.ambient));
  p.set("uSpecular", static_cast<float>(look.specular));
  p.set("uShininess", static_cast<float>(look.shininess));
  p.set("uIntensity", static_cast<float>(scene->light.intensity));
  const glm::dvec3 toLight = scene->light.direction;
  const glm::dvec3 inCamera =
      glm::length(toLight) > 0.0 ? glm::normalize(toLight) : glm::dvec3(0.0, 0.0, 1.0);
  p.set("uLight", glm::vec3(inCamera.x * view->rightWorld + inCamera.y * view->upWorld -
                            inCamera.z * view->forwardWorld));
  p.set("uDepthRange", glm::vec2(view->depthRangeMm));
  p.set("uBackgroundTop", glm::vec3(look.backgroundTop));
  p.set("uBackgroundBottom", glm::vec3(look.backgroundBottom));
  fullscreen(p);
}

void Renderer::Parts::runResolve() {
  begin(picture, pictureSize);
  resolveProgram.setTexture("uColor", 0, color.images[0]);
  resolveProgram.set("uSupersampling", request.supersampling);
  fullscreen(resolveProgram);
}

std::size_t Renderer::Parts::bytesOf(const std::string& name) const {
  if (name == pass::blocks) return faceBuffer.bytes() + activeTexture.bytes();
  if (name == pass::segments) return segments.bytes();
  if (name == pass::cast) return bracket.bytes();
  if (name == pass::refine) return surface.bytes();
  if (name == pass::gradient) return gradient.bytes();
  if (name == pass::shade) return color.bytes();
  return picture.bytes();
}

const FrameReport& Renderer::render(const scene::Scene& scene, const FrameRequest& request) {
  assert(request.size.x > 0 && request.size.y > 0 && request.supersampling >= 1);
  assert(scene.isosurface.value && scene.camera.eye && scene.camera.target && scene.camera.up);
  Parts& parts = *parts_;
  const Gl& gl = *parts.gl;
  const Clock::time_point begin = Clock::now();
  parts.scene = &scene;
  parts.request = request;
  parts.outward = scene.isosurface.inside == scene::Inside::above ? -1.0 : 1.0;

  // Others draw between our frames: every state a pass relies on is set here.
  for (const GLenum off : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DITHER,
                           GL_FRAMEBUFFER_SRGB, GL_RASTERIZER_DISCARD, GL_SAMPLE_ALPHA_TO_COVERAGE,
                           GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL})
    gl.Disable(off);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_ONE, GL_ZERO);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  for (const GLenum store :
       {GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS,
        GL_UNPACK_SKIP_IMAGES, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS})
    gl.PixelStorei(store, 0);
  for (GLuint unit = 0; unit < 3; ++unit) gl.BindSampler(unit, 0);

  parts.upload(static_cast<std::size_t>(scene.memory.gpuBudgetMb) << 20);
  parts.allocate();
  const volume::GridGeometry none = volume::GridGeometry::make(glm::ivec3(2), glm::dvec3(1.0));
  parts.view.emplace(scene.camera, static_cast<double>(request.size.x) / request.size.y,
                     parts.volume ? parts.grid().geometry() : none);

  const auto passes = declarePasses(scene, request, parts.volume ? parts.grid().hash() : 0);
  using Run = void (Parts::*)();
  const std::map<std::string, Run> runs = {
      {pass::blocks, &Parts::runBlocks},     {pass::segments, &Parts::runSegments},
      {pass::cast, &Parts::runCast},         {pass::refine, &Parts::runRefine},
      {pass::gradient, &Parts::runGradient}, {pass::shade, &Parts::runShade},
      {pass::resolve, &Parts::runResolve}};
  parts.report = {};
  std::vector<std::pair<Query, Query>> timers;  // of the passes that ran, on hardware
  std::vector<std::size_t> timed;
  for (const PlannedPass& planned : parts.graph.plan(passes, wantedImages(request))) {
    const PassDeclaration& declared = passes[planned.index];
    PassReport entry{declared.name, planned.state, planned.reason, 0.0, 0};
    if (planned.state == PassState::ran) {
      const Clock::time_point passBegin = Clock::now();
      if (!gl.software) {
        timers.emplace_back(Query(parts.gl), Query(parts.gl));
        timed.push_back(parts.report.passes.size());
        gl.QueryCounter(timers.back().first.id(), GL_TIMESTAMP);
      }
      (parts.*runs.at(declared.name))();
      if (gl.software)
        gl.Finish();  // a CPU rasteriser's own time is wall time
      else
        gl.QueryCounter(timers.back().second.id(), GL_TIMESTAMP);
      entry.milliseconds = millisecondsSince(passBegin);
      parts.graph.completed(declared);
    }
    if (planned.state != PassState::skipped) entry.bytes = parts.bytesOf(declared.name);
    parts.report.passes.push_back(std::move(entry));
  }
  gl.Finish();
  for (std::size_t i = 0; i < timers.size(); ++i) {
    GLuint64 from = 0, to = 0;
    gl.GetQueryObjectui64v(timers[i].first.id(), GL_QUERY_RESULT, &from);
    gl.GetQueryObjectui64v(timers[i].second.id(), GL_QUERY_RESULT, &to);
    parts.report.passes[timed[i]].milliseconds = static_cast<double>(to - from) * 1e-6;
  }
  gl.BindVertexArray(0);
  gl.UseProgram(0);
  parts.report.milliseconds = millisecondsSince(begin);
  parts.report.blocksActive = parts.activeCount;
  parts.report.blocksTotal = parts.volume ? parts.volume->blocks->count() : 0;
  parts.report.gpuBytes = parts.activeTexture.bytes() + parts.faceBuffer.bytes();
  for (const Target* target :
       {&parts.segments, &parts.bracket, &parts.surface, &parts.gradient, &parts.color, &parts.picture})
    parts.report.gpuBytes += target->bytes();
  for (const auto* texture : {&parts.volumeTexture, &parts.coefficients})
    if (*texture) parts.report.gpuBytes += (*texture)->texture.bytes();
  parts.scene = nullptr;
  return parts.report;
}

void Renderer::present(unsigned framebuffer, glm::ivec2 size) {
  const Gl& gl = *parts_->gl;
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
  const glm::ivec2 from = parts_->pictureSize;
  gl.BlitNamedFramebuffer(parts_->picture.framebuffer.id(), framebuffer, 0, 0, from.x, from.y, 0, 0, size.x,
                          size.y, GL_COLOR_BUFFER_BIT, from == size ? GL_NEAREST : GL_LINEAR);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

ColorImage Renderer::readColor() {
  const Gl& gl = *parts_->gl;
  ColorImage image;
  image.size = parts_->pictureSize;
  const std::size_t row = static_cast<std::size_t>(image.size.x) * 4;
  std::vector<std::uint8_t> flipped(row * static_cast<std::size_t>(image.size.y));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.GetTextureImage(parts_->picture.images[0].id(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     static_cast<GLsizei>(flipped.size()), flipped.data());
  image.rgba.resize(flipped.size());
  for (int y = 0; y < image.size.y; ++y)
    std::copy_n(
        flipped.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(image.size.y - 1 - y)),
        row, image.rgba.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y)));
  return image;
}

AovImage Renderer::readAov(Aov aov) {
  Parts& parts = *parts_;
  const glm::ivec2 size = parts.raySize;
  AovImage image{aov, size, 0, {}};
  for (const AovInfo& info : aovs())
    if (info.aov == aov) image.channels = static_cast<int>(info.channels.size());
  const std::vector<float> surface = parts.surface.images[0].readFloats(4);
  std::vector<float> extra;
  if (aov == Aov::value_error) extra = parts.surface.images[1].readFloats(1);
  if (aov == Aov::normal || aov == Aov::gradient) extra = parts.gradient.images[0].readFloats(4);
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const auto channels = static_cast<std::size_t>(image.channels);
  image.values.assign(pixels * channels, aov == Aov::hit ? 0.0f : std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* s = &surface[4 * i];
    if (s[3] < 0.0f) continue;
    const std::size_t x = i % static_cast<std::size_t>(size.x), y = i / static_cast<std::size_t>(size.x);
    float* out =
        &image.values[((static_cast<std::size_t>(size.y) - 1 - y) * static_cast<std::size_t>(size.x) + x) *
                      channels];
    const auto put = [&](const glm::dvec3& v) {
      for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(v[c]);
    };
    switch (aov) {
      case Aov::hit:
        out[0] = 1.0f;
        break;
      case Aov::voxel:
        put({s[0], s[1], s[2]});
        break;
      case Aov::position:
        put(glm::dvec3(parts.grid().geometry().worldFromVoxel * glm::dvec4(s[0], s[1], s[2], 1.0)));
        break;
      case Aov::depth:
        out[0] = static_cast<float>(s[3] + parts.rayStartMm);
        break;
      case Aov::value_error:
        out[0] = static_cast<float>(extra[i] * std::fabs(parts.dataUnitsPerTexel()));
        break;
      case Aov::gradient:
        put({extra[4 * i], extra[4 * i + 1], extra[4 * i + 2]});
        break;
      case Aov::normal: {
        const glm::dvec3 g(extra[4 * i], extra[4 * i + 1], extra[4 * i + 2]);
        const double length = glm::length(g);
        if (length > 0.0) put(g * (parts.outward / length));
        break;
      }
    }
  }
  return image;
}

std::optional<Pick> Renderer::pick(glm::ivec2 pixel) {
  Parts& parts = *parts_;
  if (!parts.volume || parts.pictureSize.x == 0 || pixel.x < 0 || pixel.y < 0 ||
      pixel.x >= parts.pictureSize.x || pixel.y >= parts.pictureSize.y)
    return std::nullopt;
  const int s = parts.raySize.x / parts.pictureSize.x;
  float surface[4];
  parts.gl->GetTextureSubImage(parts.surface.images[0].id(), 0, pixel.x * s + s / 2,
                               (parts.pictureSize.y - 1 - pixel.y) * s + s / 2, 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                               sizeof surface, surface);
  if (surface[3] < 0.0f) return std::nullopt;
  Pick pick;
  pick.voxel = {surface[0], surface[1], surface[2]};
  pick.worldMm = glm::dvec3(parts.grid().geometry().worldFromVoxel * glm::dvec4(pick.voxel, 1.0));
  pick.value = volume::sampleTrilinear(parts.grid(), pick.voxel).value;
  return pick;
}

}  // namespace isolux::render
