#include "render/renderer.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "base/error.h"
#include "render/gl/gl_messages.h"
#include "render/gl/program_cache.h"
#include "render/graph/empty_picture.h"
#include "render/passes/brick_rounds.h"
#include "render/passes/curvature_ranges.h"
#include "render/passes/cut_faces_pass.h"
#include "render/passes/frame_state.h"
#include "render/passes/hit_passes.h"
#include "render/passes/light_passes.h"
#include "render/passes/pass_declarations.h"
#include "render/passes/pass_list.h"
#include "render/passes/readback.h"
#include "render/passes/second_volume_pass.h"
#include "scene/rules/ghosts.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// Others draw between our frames: every state a pass relies on is set here.
void setKnownState(const Gl& gl) {
  for (const GLenum off : {GL_BLEND,
                           GL_DEPTH_TEST,
                           GL_CULL_FACE,
                           GL_SCISSOR_TEST,
                           GL_STENCIL_TEST,
                           GL_DITHER,
                           GL_FRAMEBUFFER_SRGB,
                           GL_RASTERIZER_DISCARD,
                           GL_SAMPLE_ALPHA_TO_COVERAGE,
                           GL_COLOR_LOGIC_OP,
                           GL_POLYGON_OFFSET_FILL,
                           GL_DEPTH_CLAMP,
                           GL_PRIMITIVE_RESTART,
                           GL_PRIMITIVE_RESTART_FIXED_INDEX,
                           GL_SAMPLE_COVERAGE,
                           GL_SAMPLE_MASK,
                           GL_MULTISAMPLE,
                           GL_CLIP_DISTANCE0,
                           GL_CLIP_DISTANCE1,
                           GL_CLIP_DISTANCE2,
                           GL_CLIP_DISTANCE3,
                           GL_CLIP_DISTANCE4,
                           GL_CLIP_DISTANCE5,
                           GL_CLIP_DISTANCE6,
                           GL_CLIP_DISTANCE7})
    gl.Disable(off);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_ONE, GL_ZERO);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  for (const GLenum store :
       {GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS,
        GL_UNPACK_SKIP_IMAGES, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_PACK_ROW_LENGTH,
        GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES, GL_PACK_SWAP_BYTES,
        GL_PACK_LSB_FIRST})
    gl.PixelStorei(store, 0);
  for (const GLenum buffer : {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_PACK_BUFFER}) gl.BindBuffer(buffer, 0);
  constexpr GLuint textureUnits = 16;
  for (GLuint unit = 0; unit < textureUnits; ++unit) gl.BindSampler(unit, 0);
}

std::vector<double> valuesOf(const std::vector<Surface>& surfaces) {
  std::vector<double> values;
  values.reserve(surfaces.size());
  for (const Surface& surface : surfaces) values.push_back(surface.value);
  return values;
}

// Of what is drawn at the hits as far as somebody reads it.
std::vector<FieldAt> fieldsReadBy(const scene::Scene& scene, const FrameRequest& request) {
  const scene::Field derived = scene.derivatives.field;
  std::vector<FieldAt> fields = {{scene.hit.field}};
  if (!readsDerivatives(scene, request)) return fields;
  fields.push_back({derived, scene::normalScale(scene)});
  const std::vector<Aov>& aovs = request.aovs;
  if (readsHessian(scene, request) || std::find(aovs.begin(), aovs.end(), Aov::gradient) != aovs.end())
    fields.push_back({derived, scene::derivativesScale(scene)});
  if (readsEdge(scene, request)) fields.push_back(edgeFieldOf(scene));
  return fields;
}

bool passRan(const FrameReport& report, const std::string& name) {
  return std::any_of(report.passes.begin(), report.passes.end(), [&](const PassReport& pass) {
    return pass.name == name && pass.state == PassState::ran;
  });
}

constexpr const char* kEndOfLayers = " layer";  // of the names of images behind transparent surfaces

// What the volume and light leave of the budget, but a quarter in any case; of a software driver, whose
// images are in main memory, half of what is left there.
std::size_t budgetOfImages(const Gl& gl, std::size_t budget, std::size_t taken, std::size_t held) {
  const std::size_t share = std::max(budget / 4, budget - std::min(budget, taken));
  return gl.software ? std::min(share, (base::machineMemory().left() + held) / 2) : share;
}

// Colours need not be there as a whole where resolve is their only reader, and reads only those of hits.
bool shadesInBands(const FrameState& frame) {
  const scene::Scene& scene = *frame.scene;
  return frame.request.color && !frame.request.linear && !scene::isTransparent(scene) &&
         !scene::showsLegend(scene) && !scene.picture.transparent && !scene::usesGi(scene) &&
         !frame.cutFaceColors;
}

// Times the passes of a frame: GPU timestamps, read when the frame is done; on a software rasteriser, whose
// own time is wall time, a clock around a finished pass.
class PassClock {
 public:
  explicit PassClock(GlPtr gl) : gl_(std::move(gl)) {}

  void begin() {
    begin_ = Clock::now();
    if (!gl_->software)
      gl_->QueryCounter(timers_.emplace_back(Query(gl_), Query(gl_)).first.id(), GL_TIMESTAMP);
  }
  void end(std::size_t reportIndex) {
    timed_.push_back(reportIndex);
    if (gl_->software)
      gl_->Finish();
    else
      gl_->QueryCounter(timers_.back().second.id(), GL_TIMESTAMP);
    wall_.push_back(millisecondsSince(begin_));
  }
  void write(std::vector<PassReport>& passes) const {
    for (std::size_t i = 0; i < timed_.size(); ++i) {
      double& milliseconds = passes[timed_[i]].milliseconds;
      if (gl_->software) {
        milliseconds += wall_[i];
        continue;
      }
      GLuint64 from = 0, to = 0;
      gl_->GetQueryObjectui64v(timers_[i].first.id(), GL_QUERY_RESULT, &from);
      gl_->GetQueryObjectui64v(timers_[i].second.id(), GL_QUERY_RESULT, &to);
      milliseconds += static_cast<double>(to - from) * 1e-6;
    }
  }

 private:
  GlPtr gl_;
  Clock::time_point begin_;
  std::vector<std::pair<Query, Query>> timers_;
  std::vector<std::size_t> timed_;
  std::vector<double> wall_;
};

}  // namespace

struct Renderer::Parts {
  explicit Parts(const GlPtr& gl) : frame(gl), passes(makePasses()) {}

  FrameState frame;
  PassList passes;
  FrameGraph graph;
  FrameReport report;
  DrawnFrame drawn;
  std::vector<std::pair<const Pass*, std::string>> held;  // images of the last frame, and who wrote them
  std::shared_ptr<const volume::PreparedVolume> volume;
  std::optional<scene::Scene> completedScene;  // of completed()
  scene::Memory memory;
  scene::Executor executor = scene::Executor::automatic;
  std::uint64_t copiesMade = 0;                // VolumeState::made
  std::uint64_t bricksAsked = 0;               // BrickState::asked
  BrickRounds::Unfinished unfinished;          // of the last frame that cast rays
  bool hit = false;                            // some ray of the last frame that cast rays hit a surface
  bool hitsChanged = false;                    // since the last frame that was completed
  bool complete = true;                        // the last frame had all the time it needed
  bool imagesDropped = false;                  // in this frame, because their size is another
  std::size_t imageBudget = 0;                 // bytes
  std::map<std::string, std::size_t> lastUse;  // of each image in this frame: render::lastUses()

  // With what is automatic about derivatives where the picture reads them and nobody has filled it in.
  const scene::Scene& completed(const scene::Scene& scene, const FrameRequest& request);
  void prepare(const scene::Scene& scene, const FrameRequest& request);
  // Blocks of other sizes are those of benchmarks.
  bool hasMasks() const { return volume->blocks->blockCells() == volume::BoxBounds::kBlockCells; }
  VolumeState volumeState() const;
  BrickState brickState();
  // Those of the plan that are not skipped are the frame's.
  void plan(const std::vector<PassDeclaration>& declared, const std::vector<PlannedPass>& planned);
  void run(Pass& pass, const std::vector<Pass*>& running);
  void planMemory(const std::vector<PassDeclaration>& declared, const std::vector<PlannedPass>& planned);
  // Of a frame that keeps no images: which parts of images are drawn in turn.
  void planBands(const std::vector<PassDeclaration>& declared, const std::vector<PlannedPass>& planned);
  // Frees images that no pass from `next` on reads, until what is held and what `next` writes fit the budget.
  void makeRoom(const std::vector<PassDeclaration>& declared, std::size_t next);
  bool freeLargest(const std::vector<PassDeclaration>& declared, std::size_t next);
  // In a frame that keeps no images: frees those that no pass after this one reads.
  void freeAfter(std::size_t index);
  // Runs shade and resolve in turn, band by band.
  void runInBands(std::size_t shade, std::size_t resolve, PassClock& clock);
  // In bricks: `pass` casts rays, `running` are the passes of this frame that run.
  void runInBricks(Pass& pass, const std::vector<Pass*>& running);
  void reportBricks();
  // A frame has ended before it was complete. Stopped: the passes that were complete are good for the next
  // one; otherwise nothing that was drawn is still there.
  void leave(bool stopped);
  void noteHits();      // after a pass that found some
  void forgetImages();  // after a frame that keeps none
  std::size_t bytesOf(const Pass& pass, const PassDeclaration& declared) const;
};

Renderer::Renderer(const std::shared_ptr<const Gl>& gl) : parts_(std::make_unique<Parts>(gl)) {}
Renderer::~Renderer() = default;

void Renderer::setMachine(const scene::Machine& machine) {
  parts_->memory = machine.memory;
  parts_->memory.gpuBudgetMb = parts_->frame.gl->budgetMb(machine.memory.gpuBudgetMb);
  parts_->executor = machine.executor;
}

void Renderer::setVolume(std::shared_ptr<const volume::PreparedVolume> volume) {
  if (volume == parts_->volume) return;
  parts_->volume = std::move(volume);
  parts_->frame.volume.reset();
}

void Renderer::setLight(std::shared_ptr<const gi::PictureLight> light) {
  parts_->frame.light = std::move(light);
}

void Renderer::invalidate() {
  parts_->graph.invalidate();
  for (const auto& pass : parts_->passes) pass->forget();
}

const scene::Scene& Renderer::Parts::completed(const scene::Scene& scene, const FrameRequest& request) {
  const bool ghosts = scene.isosurface.ghost > 0.0;
  const bool unread = volume && !scene.color.volume.empty() && !volume->secondVolumes->find(scene.color);
  const bool derived = readsDerivatives(scene, request);
  if (!volume || !(ghosts || unread || derived)) return scene;
  completedScene = scene;
  if (unread) completedScene->color.volume.clear();  // the surface without it
  if (!ghosts && !derived) return *completedScene;
  base::Progress unwatched;
  volume->derivativeChoices->complete(*completedScene, unwatched);
  scene::addGhosts(*completedScene);
  return *completedScene;
}

void Renderer::Parts::prepare(const scene::Scene& scene, const FrameRequest& request) {
  const int longest = std::max(request.size.x, request.size.y) * request.supersampling;
  if (!request.tile && longest > frame.gl->maxImage)
    throw base::Error(
        base::ErrorKind::memory, "", "graphics memory",
        "a picture of " + std::to_string(longest) + " rays on an axis is too large for one frame");
  frame.scene = &scene;
  frame.request = request;
  frame.hitPart.reset();
  frame.bandRows = frame.bandRow = 0;
  frame.gradientInStrips = false;
  frame.surfaces = surfacesOf(scene);
  base::Progress unwatched;
  frame.hidden.clear();
  if (volume) frame.hidden = volume::hiddenOf(scene, *volume->pieces, unwatched);
  frame.prepared = volume.get();
  frame.cut = volume ? volume::SurfaceCut(scene, volume->grid().geometry()) : volume::SurfaceCut();
  frame.cutFaceColors.reset();
  if (volume && scene::showsCutFaces(scene)) {
    frame.cutFaceColors = std::make_unique<CutFaceColors>(cutFaceColors(scene, *volume));
    for (const scene::Field field : {scene.hit.field, scene.slice.field})
      if (field == scene::Field::cubic_interpolating) volume->cubicFields->make(field, unwatched);
  }
  if (volume && !frame.volume) {
    frame.volume.emplace(frame.gl, volume);
    ++copiesMade;
  }
  // The processor reads voxels in memory, shaders bricks of those that stay in a file.
  const bool readable = volume && volume->grid().isWhole();
  frame.onProcessor = onProcessor(readable && hasMasks() && takesProcessor(executor, *frame.gl), scene);
  if (frame.volume && frame.onProcessor.all) {
    frame.volume->requireFields(fieldsReadBy(scene, request));
  } else if (frame.volume) {
    frame.volume->require(fieldsReadBy(scene, request), memory);
    // Shaders at the hits find only bricks that rays of shaders have asked for.
    if (frame.volume->bricks()) frame.onProcessor = {};
  }
  frame.crossed = frame.volume && frame.volume->mayCross(scene.hit.field, valuesOf(frame.surfaces));
  frame.second = volume && readsSecond(scene, request) ? volume->secondVolumes->find(scene.color) : nullptr;
  frame.pieces = volume ? volume->pieces : nullptr;
  frame.readsLight =
      (request.color && scene::usesGi(scene)) ||
      std::find(request.aovs.begin(), request.aovs.end(), Aov::irradiance) != request.aovs.end();
  // What the volume leaves of the budget, but a quarter in any case: a cache of bricks takes all there is.
  const std::size_t budget = static_cast<std::size_t>(memory.gpuBudgetMb) << 20;
  const std::size_t taken = frame.volume ? frame.volume->bytes() : 0;
  frame.lighting->prepare(frame, std::max(budget / 4, budget - std::min(budget, taken)));
  imageBudget = budgetOfImages(*frame.gl, budget, taken + frame.lighting->bytes(), frame.images.bytes());
  const volume::GridGeometry none = volume::GridGeometry::make(glm::ivec3(2), glm::dvec3(1.0));
  frame.view.emplace(scene.camera, static_cast<double>(request.size.x) / request.size.y,
                     volume ? volume->grid().geometry() : none);
  // The size is a parameter of the passes, so that images of another size are drawn anew.
  imagesDropped = drawn.raySize != frame.raySize();
  if (imagesDropped) {
    frame.images.clear();
    frame.host.clear();
  }
  drawn = {frame.raySize(),
           frame.drawnSize(),
           frame.view->rayStartMm,
           frame.view->startDepth,
           frame.view->halfExtent,
           request.size * request.supersampling,
           frame.tileOrigin() * request.supersampling,
           frame.outward(),
           scene.hit.field,
           scene::isTransparent(scene),
           scene::derivativesScale(scene),
           frame.light != nullptr,
           scene.picture.transparent};
}

void Renderer::Parts::plan(const std::vector<PassDeclaration>& declared,
                           const std::vector<PlannedPass>& planned) {
  frame.used.clear();
  held.clear();
  frame.withHessian = frame.gradientShared = false;
  for (const PlannedPass& entry : planned) {
    if (entry.state == PassState::skipped) continue;
    frame.used.push_back(passes[entry.index].get());
    for (const std::string& image : declared[entry.index].writes) {
      held.emplace_back(frame.used.back(), image);
      frame.withHessian = frame.withHessian || image == image::hessian;
      if (image == image::gradient) frame.gradientShared = frame.used.back()->name == pass::hessian;
    }
  }
}

void Renderer::Parts::planMemory(const std::vector<PassDeclaration>& declared,
                                 const std::vector<PlannedPass>& planned) {
  std::vector<std::string> atEnd = wantedImages(frame.request, *frame.scene);
  if (frame.request.keepImages) atEnd.insert(atEnd.end(), {image::surface, image::color});  // to read back
  lastUse = lastUses(declared, planned, atEnd);
  if (!frame.request.keepImages) {  // nothing of earlier frames is left but what tiles share
    for (const PassDeclaration& pass : declared)
      for (const std::string& image : pass.writes) frame.images.drop(image);
    frame.images.dropEnding(kEndOfLayers);
    frame.images.dropFree();
    frame.host.clear();
  }
  frame.images.beginPeak();
  if (!frame.request.keepImages && shadesInBands(frame)) planBands(declared, planned);
}

void Renderer::Parts::planBands(const std::vector<PassDeclaration>& declared,
                                const std::vector<PlannedPass>& planned) {
  constexpr int pixels = 64;
  frame.bandRows = pixels * frame.request.supersampling;
  const auto indexOf = [&](const char* name) {
    const auto same = [&](const PassDeclaration& pass) { return pass.name == name; };
    return static_cast<std::size_t>(std::find_if(declared.begin(), declared.end(), same) - declared.begin());
  };
  for (auto& [image, last] : lastUse)
    if (last == indexOf(pass::shade)) last = indexOf(pass::resolve);
  const bool drawn = planned[indexOf(pass::gradient)].state == PassState::ran;
  frame.gradientInStrips = frame.onProcessor.all && !frame.gradientShared && drawn;
  for (const PlannedPass& one : planned) {
    const PassDeclaration& pass = declared[one.index];
    const bool reads = std::find(pass.reads.begin(), pass.reads.end(), image::gradient) != pass.reads.end();
    const auto inStrips = {pass::openness, pass::shadow, pass::shade};
    if (one.state != PassState::skipped && reads &&
        std::find(inStrips.begin(), inStrips.end(), pass.name) == inStrips.end())
      frame.gradientInStrips = false;
  }
}

bool Renderer::Parts::freeLargest(const std::vector<PassDeclaration>& declared, std::size_t next) {
  const std::string* largest = nullptr;
  std::size_t writer = 0, most = 0;
  for (std::size_t i = 0; i < declared.size(); ++i)
    for (std::size_t k = 0; k < declared[i].writes.size(); ++k) {
      const std::string& image = declared[i].writes[k];
      const auto last = lastUse.find(image);
      if (declared[i].bytes[k] <= 0 || (last != lastUse.end() && last->second >= next)) continue;
      const std::size_t bytes = frame.images.bytesOf(image);
      if (bytes <= most) continue;
      most = bytes;
      largest = &image;
      writer = i;
    }
  if (!largest) return false;
  frame.images.drop(*largest);
  frame.images.dropFree();
  graph.freed(declared[writer].name);
  return true;
}

void Renderer::Parts::makeRoom(const std::vector<PassDeclaration>& declared, std::size_t next) {
  // In bricks, what is freed could be made again only from bricks that may be gone.
  if (!frame.request.keepImages || frame.bricks()) return;
  std::size_t more = 0;
  if (next < declared.size())
    for (std::size_t k = 0; k < declared[next].writes.size(); ++k)
      if (declared[next].bytes[k] > 0 && !frame.images.has(declared[next].writes[k]))
        more += static_cast<std::size_t>(declared[next].bytes[k]) *
                static_cast<std::size_t>(frame.raySize().x) * static_cast<std::size_t>(frame.raySize().y);
  if (frame.images.bytes() + more <= imageBudget) return;
  frame.images.dropEnding(kEndOfLayers);
  frame.images.dropFree();
  while (frame.images.bytes() + more > imageBudget && freeLargest(declared, next)) {
  }
}

void Renderer::Parts::freeAfter(std::size_t index) {
  if (frame.request.keepImages) return;
  if (passes[index]->name == pass::layers) frame.images.dropEnding(kEndOfLayers);
  for (const auto& [image, last] : lastUse) {
    if (last != index) continue;
    frame.images.drop(image);
    releaseHostImages(frame, image);
  }
}

void Renderer::Parts::runInBands(std::size_t shade, std::size_t resolve, PassClock& clock) {
  for (frame.bandRow = 0; frame.bandRow < frame.raySize().y; frame.bandRow += frame.bandRows)
    for (const std::size_t index : {shade, resolve}) {
      throwIfStopped(frame.request);
      clock.begin();
      passes[index]->run(frame);
      clock.end(index);
    }
  frame.bandRow = 0;
}

void Renderer::Parts::run(Pass& pass, const std::vector<Pass*>& running) {
  if (pass.kind.castsRays) frame.keepHits = false;
  if (pass.kind.castsRays && frame.bricks())
    runInBricks(pass, running);
  else
    pass.run(frame);
}

VolumeState Renderer::Parts::volumeState() const {
  VolumeState state{volume ? volume->grid().hash() : 0, copiesMade};
  state.second = frame.second ? frame.second->grid().hash() : 0;
  state.crossed = frame.crossed;
  state.hidden = volume::keyOf(frame.hidden);
  return state;
}

BrickState Renderer::Parts::brickState() {
  const Bricks* const bricks = frame.bricks();
  if (!bricks) {
    unfinished = {};
    return {};
  }
  // What did not come in time may come now.
  if (unfinished.waiting > 0 && !complete && frame.request.brickUploadBytes == 0) ++bricksAsked;
  return {true, !bricks->holdsAll(), frame.volume->bricksMade(), bricksAsked};
}

void Renderer::Parts::runInBricks(Pass& pass, const std::vector<Pass*>& running) {
  BrickRounds rounds(frame, pass, [&] {
    for (Pass* const at : running)
      if (at->kind.atHits) at->run(frame);
    frame.keepHits = true;
  });
  if (pass.name == pass::cast)
    unfinished = rounds.cast();
  else {
    const BrickRounds::Unfinished now = rounds.draw();
    unfinished = {std::max(unfinished.waiting, now.waiting), std::max(unfinished.lost, now.lost)};
  }
}

void Renderer::Parts::reportBricks() {
  const Bricks* const bricks = frame.bricks();
  if (!bricks) return;
  const glm::ivec3 dims = bricks->dims();
  const auto share = [this](std::size_t rays) {
    return static_cast<double>(rays) / (static_cast<double>(frame.raySize().x) * frame.raySize().y);
  };
  BrickReport& out = report.bricks;
  out = {
      true,
      static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z),
      frame.volume->activeBricks(),
      bricks->resident(),
      bricks->slots(),
      bricks->uploaded(),
      bricks->evicted(),
      share(unfinished.waiting),
      share(unfinished.lost),
      bricks->lost(),
      bricks->lostReason(),
      frame.request.brickUploadBytes > 0 && unfinished.waiting > 0 && bricks->canServe(bricks->frameRound())};
  if (out.pending) ++bricksAsked;
  for (PassReport& pass : report.passes)
    if (pass.name == pass::bricks && out.uploaded > 0) {
      pass.state = PassState::ran;
      pass.reason = "rays asked for " + std::to_string(out.uploaded) + " bricks";
      pass.milliseconds = bricks->uploadMilliseconds();
    }
}

std::size_t Renderer::Parts::bytesOf(const Pass& pass, const PassDeclaration& declared) const {
  if (const std::optional<std::size_t> own = pass.bytes(frame)) return *own;
  std::size_t sum = 0;
  for (const std::string& image : declared.writes) sum += frame.images.bytesOf(image);
  return sum;
}

void Renderer::Parts::noteHits() {
  hitsChanged = true;
  if (frame.images.has(image::surface)) hit = anyHit(frame) || frame.seesCutFaces();
}

void Renderer::Parts::forgetImages() {
  graph.invalidate();
  if (frame.request.aovs.empty()) frame.host.clear();  // else Hessians may be read back
  frame.hitPart.reset();
}

void Renderer::Parts::leave(bool stopped) {
  const bool inRounds = frame.bricks() != nullptr;  // of which bricks and rays know their own
  if (!stopped) {
    frame.images.clear();
    drawn = {};
  }
  if (!stopped || inRounds) graph.invalidate();
  if (!frame.request.keepImages) forgetImages();
  frame.scene = nullptr;
  frame.prepared = nullptr;
  frame.layer.clear();
  frame.onlyWaiting = frame.keepHits = false;
  frame.gl->BindVertexArray(0);
  frame.gl->UseProgram(0);
}

const FrameReport& Renderer::render(const scene::Scene& asked, const FrameRequest& request) {
  assert(request.size.x > 0 && request.size.y > 0 && request.supersampling >= 1);
  assert(asked.isosurface.value && asked.camera.eye && asked.camera.target && asked.camera.up);
  Parts& parts = *parts_;
  const scene::Scene& scene = parts.completed(asked, request);
  const Gl& gl = *parts.frame.gl;
  const Clock::time_point begin = Clock::now();
  const std::size_t errorsBefore = glErrors().size();
  setKnownState(gl);
  parts.report = {};
  try {
    parts.prepare(scene, request);
    Bricks* const bricks = parts.frame.bricks();
    const auto declared =
        declarePasses(parts.passes, Asked(scene, request, parts.volumeState(), parts.brickState(),
                                          parts.frame.lighting->state(parts.frame), parts.frame.onProcessor));
    if (!request.keepImages) parts.graph.invalidate();
    const auto plan = parts.graph.plan(declared, wantedImages(request, scene));
    parts.plan(declared, plan);
    parts.planMemory(declared, plan);
    for (const PlannedPass& entry : plan)
      if (parts.imagesDropped && entry.state != PassState::cached)
        parts.graph.forget(declared[entry.index].name);
    std::vector<Pass*> running;
    for (const PlannedPass& entry : plan)
      if (entry.state == PassState::ran) running.push_back(parts.passes[entry.index].get());
    if (bricks) bricks->beginFrame();
    PassClock clock(parts.frame.gl);
    std::size_t shade = 0;  // its place, if it is drawn in bands
    for (const PlannedPass& now : plan) {
      Pass& pass = *parts.passes[now.index];
      PassReport entry{
          std::string(pass.name), now.state, now.reason, 0.0, 0, pass.isOn(parts.frame.onProcessor)};
      const bool inBands = parts.frame.bandRows > 0;
      if (now.state == PassState::ran && inBands && pass.name == pass::shade) {
        shade = now.index;  // with resolve
      } else if (now.state == PassState::ran && inBands && pass.name == pass::resolve) {
        parts.runInBands(shade, now.index, clock);
      } else if (now.state == PassState::ran) {
        throwIfStopped(request);
        parts.makeRoom(declared, now.index);
        clock.begin();
        if (!now.remade) parts.graph.forget(entry.name);  // from its beginning on, what it wrote is gone
        parts.run(pass, running);
        throwIfStopped(request);
        clock.end(parts.report.passes.size());
        parts.graph.completed(declared[now.index]);
        if (!now.remade && (pass.name == pass::cast || pass.name == pass::refine)) parts.noteHits();
      }
      if (now.state != PassState::skipped) entry.bytes = parts.bytesOf(pass, declared[now.index]);
      parts.report.passes.push_back(std::move(entry));
      parts.freeAfter(now.index);
    }
    parts.makeRoom(declared, declared.size());
    gl.Finish();
    clock.write(parts.report.passes);
  } catch (const base::Error& error) {
    parts.leave(error.kind() == base::ErrorKind::interrupted);
    throw;
  } catch (...) {
    parts.leave(false);
    throw;
  }
  gl.BindVertexArray(0);
  gl.UseProgram(0);
  if (passRan(parts.report, pass::cast)) parts.complete = request.brickUploadBytes == 0;
  parts.reportBricks();
  if (parts.frame.readsLight) parts.frame.lighting->report(parts.report.light);
  if (parts.volume && parts.unfinished.waiting == 0 && parts.unfinished.lost == 0)
    parts.report.empty = whyEmpty(scene, *parts.volume, static_cast<double>(request.size.x) / request.size.y,
                                  !parts.frame.empty() || parts.frame.seesCutFaces(), parts.hit);
  if (parts.frame.withHessian && request.color && scene::needsCurvature(scene)) {
    const volume::CurvatureStatistics& surface = parts.frame.statistics;
    const double flat = parts.frame.flatCurvature();
    parts.report.curvature = {measureRange(scene, surface, flat), ridgeThresholds(scene, surface, flat)};
  }
  if (gl.programs) parts.report.programs = gl.programs->counts();
  if (request.color) parts.report.legend = parts.frame.legend;
  parts.report.surfaceChanged = std::exchange(parts.hitsChanged, false);
  parts.report.milliseconds = millisecondsSince(begin);
  parts.report.blocksTotal = parts.volume ? parts.volume->blocks->count() : 0;
  parts.report.imageBytes = parts.frame.images.peakBytes();
  parts.report.gpuBytes = parts.report.imageBytes + parts.frame.lighting->bytes();
  if (parts.frame.volume) {
    parts.report.blocksActive = parts.frame.volume->activeBlocks();
    if (!parts.frame.empty())
      parts.report.found = foundNumbers(scene, parts.frame.statistics, parts.frame.flatCurvature());
    if (!parts.frame.empty() && parts.frame.second && request.color)
      addSecondRange(parts.frame, parts.report.found);
    parts.report.gpuBytes += parts.frame.volume->bytes();
  }
  parts.frame.scene = nullptr;
  parts.frame.prepared = nullptr;
  if (!request.keepImages) parts.forgetImages();
  parts.frame.images.dropFree();
  const std::vector<std::string>& errors = glErrors();
  if (errors.size() > errorsBefore)
    parts.report.glErrors.assign(errors.begin() + static_cast<std::ptrdiff_t>(errorsBefore), errors.end());
  return parts.report;
}

const Texture& Renderer::color() const {
  return parts_->frame.images.at(image::picture).images[0];
}

ColorImage Renderer::readColor() {
  return render::readColor(parts_->frame, parts_->drawn);
}

std::size_t Renderer::imageBudget() const {
  const Parts& parts = *parts_;
  const std::size_t volume = parts.frame.volume ? parts.frame.volume->bytes() : 0;
  return budgetOfImages(*parts.frame.gl, static_cast<std::size_t>(parts.memory.gpuBudgetMb) << 20,
                        volume + parts.frame.lighting->bytes(), parts.frame.images.bytes());
}

LinearImage Renderer::readLinear() {
  return render::readLinear(parts_->frame);
}

LinearImage Renderer::readLinearPicture() {
  return render::readLinearPicture(parts_->frame, parts_->drawn);
}

AovImage Renderer::readAov(Aov aov) {
  return render::readAov(parts_->frame, parts_->drawn, aov);
}

gi::SeenPoints Renderer::hitVoxels() {
  return render::hitVoxels(parts_->frame, parts_->drawn);
}

std::map<std::string, std::uint64_t> Renderer::imageHashes() {
  const FrameState& frame = parts_->frame;
  std::map<std::string, base::Hasher> hashes;
  for (const auto& [pass, image] : parts_->held) {
    // With Hessians, the gradients are the first image of theirs.
    if (!frame.images.has(image) || (frame.gradientShared && image == image::gradient)) continue;
    for (const Texture& texture : frame.images.at(image).images)
      for (const float value : texture.readFloats(4)) hashes[std::string(pass->name)].add(value);
  }
  return {hashes.begin(), hashes.end()};
}

}  // namespace isolux::render
