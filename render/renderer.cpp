#include "render/renderer.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "base/clock.h"
#include "base/error.h"
#include "render/gl/gl_messages.h"
#include "render/gl/program_cache.h"
#include "render/graph/empty_picture.h"
#include "render/passes/curvature_ranges.h"
#include "render/passes/cut_faces_pass.h"
#include "render/passes/light_passes.h"
#include "render/passes/pass_declarations.h"
#include "render/passes/passes.h"
#include "render/passes/second_volume_pass.h"
#include "render/renderer_parts.h"
#include "scene/rules/ghosts.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

// Of what is drawn at the hits as far as somebody reads it.
std::vector<FieldAt> fieldsReadBy(const scene::Scene& scene, const FrameRequest& request) {
  const scene::Field derived = scene.derivatives.field;
  std::vector<FieldAt> fields = {{scene.hit.field}};
  if (!readsDerivatives(scene, request)) return fields;
  fields.push_back({derived, scene::normalScale(scene)});
  if (readsHessian(scene, request) || request.asksFor(Aov::gradient))
    fields.push_back({derived, scene::derivativesScale(scene)});
  if (readsEdge(scene, request)) fields.push_back(edgeFieldOf(scene));
  return fields;
}

bool writesHits(const PassDeclaration& pass) {
  return std::ranges::find(pass.writes, image::surface) != pass.writes.end();
}

bool passRan(const FrameReport& report, const std::string& name) {
  return std::any_of(report.passes.begin(), report.passes.end(), [&](const PassReport& pass) {
    return pass.name == name && pass.state == PassState::ran;
  });
}

}  // namespace

Renderer::Renderer(const std::shared_ptr<const Gl>& gl) : parts_(std::make_unique<Parts>(gl)) {}
Renderer::~Renderer() = default;

void Renderer::setHostSettings(const scene::HostSettings& machine) {
  parts_->memory = machine.memory;
  parts_->memory.gpuBudgetMb = parts_->frame.gl->budgetMb(machine.memory.gpuBudgetMb);
  parts_->executor = machine.executor;
}

void Renderer::setVolume(std::shared_ptr<const volume::PreparedVolume> volume) {
  if (volume == parts_->volume) return;
  parts_->volume = std::move(volume);
  parts_->frame.volumes.clear();
  parts_->frame.volume = nullptr;
}

void Renderer::setLight(std::shared_ptr<const gi::PictureLight> light) {
  parts_->frame.light = std::move(light);
}

void Renderer::invalidate() {
  parts_->graph.invalidate();
  *parts_->frame.lookTextures = {};
}

const scene::Scene& Renderer::Parts::completed(const scene::Scene& scene, const FrameRequest& request) {
  const auto hasGhosts = [](const scene::Surface& surface) { return surface.ghost > 0.0; };
  const bool ghosts = std::ranges::any_of(scene.surfaces, hasGhosts);
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

void Renderer::Parts::takeVolumes(const scene::Scene& scene) {
  frame.surfaces = surfacesOf(scene);
  base::Progress unwatched;
  std::vector<std::shared_ptr<const volume::PreparedVolume>> wanted;
  if (volume) wanted = volume::labelFields(*volume, scene, unwatched);
  labelFields = wanted.size();
  if (labelFields > 0) {  // surfaces without a shown label have no field
    std::vector<Surface> shown;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (wanted[i]) shown.push_back(frame.surfaces[i]);
    frame.surfaces = std::move(shown);
    std::erase(wanted, nullptr);
    labelFields = std::max<std::size_t>(wanted.size(), 1);
  }
  if (volume && wanted.empty()) wanted = {volume};
  frame.volume = nullptr;  // also if what follows throws
  std::vector<std::unique_ptr<GpuVolume>> before = std::exchange(frame.volumes, {});
  for (const auto& prepared : wanted) {
    const auto kept =
        std::ranges::find_if(before, [&](const auto& one) { return one && one->prepared() == prepared; });
    if (kept != before.end()) {
      frame.volumes.push_back(std::move(*kept));
      continue;
    }
    frame.volumes.push_back(std::make_unique<GpuVolume>(frame.gl, prepared));
    ++copiesMade;
  }
  for (const auto& one : frame.volumes)
    one->setHidden(volume::hiddenOf(scene, *one->prepared()->pieces, unwatched));
  frame.takeGroup(0);
}

void Renderer::Parts::requireFields(const scene::Scene& scene, const FrameRequest& request) {
  const std::vector<FieldAt> fields = fieldsReadBy(scene, request);
  scene::Memory left = memory;
  if (frame.isOfLabels()) left.layout = scene::MemoryLayout::whole;  // bricks are those of one volume
  for (const auto& one : frame.volumes) {
    if (frame.onProcessor.all) {
      one->requireFields(fields);
      continue;
    }
    one->require(fields, left);
    if (frame.isOfLabels())
      left.gpuBudgetMb -= std::min(left.gpuBudgetMb, static_cast<int>(one->bytes() >> 20));
    // Shaders at the hits find only bricks that rays of shaders have asked for.
    if (one->bricks()) frame.onProcessor = {};
  }
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
  takeVolumes(scene);
  frame.prepared = volume.get();
  frame.cut = volume ? volume::SurfaceCut(scene, volume->grid().geometry()) : volume::SurfaceCut();
  frame.cutFaceColors.reset();
  if (volume && scene::showsCutFaces(scene)) {
    frame.cutFaceColors = std::make_unique<CutFaceColors>(cutFaceColors(scene, *volume));
    for (const scene::Field field : {scene.hit.field, scene.slice.field})
      if (base::Progress unwatched; field == scene::Field::cubic_interpolating)
        volume->cubicFields->make(field, unwatched);
  }
  // The processor reads voxels in memory, shaders bricks of those that stay in a file.
  const bool readable = volume && volume->grid().isWhole();
  frame.onProcessor = onProcessor(readable && hasMasks() && takesProcessor(executor, *frame.gl), scene);
  requireFields(scene, request);
  frame.crossed = false;
  frame.forVolumes([&] {
    frame.crossed = frame.crossed || (frame.volume && frame.volume->mayCross(
                                                          scene.hit.field, valuesOf(frame.volumeSurfaces())));
  });
  frame.second = volume && readsSecond(scene, request) ? volume->secondVolumes->find(scene.color) : nullptr;
  frame.readsLight = (request.color && scene::usesGi(scene)) || request.asksFor(Aov::irradiance);
  frame.lighting->prepare(frame, budgetWithout(volumeBytes()));
  imageBudget = budgetOfImages();
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

void Renderer::Parts::plan() {
  const scene::Scene& scene = *frame.scene;
  declared = declarePasses(passes, Asked(scene, frame.request, volumeState(), brickState(),
                                         frame.lighting->state(frame), frame.onProcessor));
  if (!frame.request.keepImages) graph.invalidate();
  planned = graph.plan(declared, wantedImages(frame.request, scene));
  frame.used.clear();
  frame.withHessian = frame.gradientShared = false;
  for (const PlannedPass& entry : planned) {
    if (entry.state == PassState::skipped) continue;
    frame.used.push_back(&passes[entry.index]);
    for (const std::string& image : declared[entry.index].writes) {
      frame.withHessian = frame.withHessian || image == image::hessian;
      if (image == image::gradient) frame.gradientShared = frame.used.back()->name == pass::hessian;
    }
  }
  planMemory();
  for (const PlannedPass& entry : planned)
    if (imagesDropped && entry.state != PassState::cached) graph.forget(declared[entry.index].name);
}

void Renderer::Parts::draw() {
  if (Bricks* const bricks = frame.bricks()) bricks->beginFrame();
  PassClock clock(frame.gl);
  for (const PlannedPass& now : planned) {
    const Pass& pass = passes[now.index];
    const bool ran = now.state == PassState::ran, inBands = ran && frame.bandRows > 0;
    if (inBands && pass.name == pass::resolve)
      runInBands(clock);
    else if (ran && !(inBands && pass.name == pass::shade))
      run(now, clock);
    report.passes.push_back({std::string(pass.name), now.state, now.reason, 0.0,
                             now.state == PassState::skipped ? 0 : bytesOf(now.index),
                             pass.isOn(frame.onProcessor)});
    freeAfter(now.index);
  }
  makeRoom(declared.size());
  frame.gl->Finish();
  clock.write(report.passes);
}

void Renderer::Parts::run(const PlannedPass& now, PassClock& clock) {
  const Pass& pass = passes[now.index];
  throwIfStopped(frame.request);
  makeRoom(now.index);
  clock.begin();
  if (!now.remade) graph.forget(declared[now.index].name);  // from its beginning on, what it wrote is gone
  if (pass.kind.castsRays) frame.keepHits = false;
  if (pass.kind.castsRays && frame.bricks())
    runInBricks(pass);
  else
    pass.run(frame);
  throwIfStopped(frame.request);
  clock.end(now.index);
  graph.completed(declared[now.index]);
  if (!now.remade && writesHits(declared[now.index])) noteHits();
}

void Renderer::Parts::runInBands(PassClock& clock) {
  for (frame.bandRow = 0; frame.bandRow < frame.raySize().y; frame.bandRow += frame.bandRows)
    for (const std::size_t index : {indexOf(pass::shade), indexOf(pass::resolve)}) {
      throwIfStopped(frame.request);
      clock.begin();
      passes[index].run(frame);
      clock.end(index);
    }
  frame.bandRow = 0;
}

VolumeState Renderer::Parts::volumeState() const {
  VolumeState state{volume ? volume->grid().hash() : 0, copiesMade};
  if (labelFields > 0) {
    base::Hasher hash;
    hash.add(state.hash);
    for (const auto& one : frame.volumes) hash.add(one->grid().hash());
    state.hash = hash;
  }
  state.hasLabels = volume && volume->labels;
  state.labelFields = labelFields;
  state.second = frame.second ? frame.second->grid().hash() : 0;
  state.crossed = frame.crossed;
  base::Hasher hidden;
  for (const auto& one : frame.volumes) hidden.add(volume::keyOf(one->hidden()));
  if (frame.volume) state.hidden = frame.isOfLabels() ? hidden : volume::keyOf(frame.volume->hidden());
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

void Renderer::Parts::runInBricks(const Pass& pass) {
  BrickRounds rounds(frame, pass, [&] {
    for (const PlannedPass& at : planned)
      if (at.state == PassState::ran && passes[at.index].kind.atHits) passes[at.index].run(frame);
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
  const auto share = [this](std::size_t rays) {
    return static_cast<double>(rays) / (static_cast<double>(frame.raySize().x) * frame.raySize().y);
  };
  BrickReport& out = report.bricks;
  out = {
      true,
      volume::Extent3{bricks->dims()}.count(),
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

std::size_t Renderer::Parts::indexOf(std::string_view pass) const {
  const auto found = std::ranges::find(declared, pass, &PassDeclaration::name);
  return static_cast<std::size_t>(found - declared.begin());
}

std::size_t Renderer::Parts::bytesOf(std::size_t pass) const {
  if (passes[pass].bytes) return passes[pass].bytes(frame);
  std::size_t sum = 0;
  for (const std::string& image : declared[pass].writes) sum += frame.images.bytesOf(image);
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

void Renderer::Parts::endFrame() {
  if (!frame.request.keepImages) forgetImages();
  frame.scene = nullptr;
  frame.prepared = nullptr;
  frame.gl->BindVertexArray(0);
  frame.gl->UseProgram(0);
}

void Renderer::Parts::leave(bool stopped) {
  const bool inRounds = frame.bricks() != nullptr;  // of which bricks and rays know their own
  if (!stopped) {
    frame.images.clear();
    drawn = {};
  }
  if (!stopped || inRounds) graph.invalidate();
  frame.layer.clear();
  frame.onlyWaiting = frame.keepHits = false;
  endFrame();
}

void Renderer::Parts::writeReport() {
  const scene::Scene& scene = *frame.scene;
  const FrameRequest& request = frame.request;
  if (passRan(report, pass::cast)) complete = request.brickUploadBytes == 0;
  reportBricks();
  if (frame.readsLight) frame.lighting->report(report.light);
  if (volume && unfinished.waiting == 0 && unfinished.lost == 0)
    report.empty = whyEmpty(scene, *volume, static_cast<double>(request.size.x) / request.size.y,
                            !frame.empty() || frame.seesCutFaces(), hit);
  if (frame.withHessian && request.color && scene::needsCurvature(scene)) {
    const double flat = frame.flatCurvature();
    report.curvature = {measureRange(scene, frame.statistics, flat),
                        ridgeThresholds(scene, frame.statistics, flat)};
  }
  if (frame.gl->programs) report.programs = frame.gl->programs->counts();
  if (request.color) report.legend = frame.legend;
  report.surfaceChanged = std::exchange(hitsChanged, false);
  report.blocksTotal = volume ? volume->blocks->count() : 0;
  report.imageBytes = frame.images.peakBytes();
  report.gpuBytes = report.imageBytes + frame.lighting->bytes() + volumeBytes();
  if (!frame.volume) return;
  for (const auto& one : frame.volumes) report.blocksActive += one->activeBlocks();
  if (frame.empty()) return;
  report.found = foundNumbers(scene, frame.statistics, frame.flatCurvature());
  if (frame.second && request.color) addSecondRange(frame, report.found);
}

const FrameReport& Renderer::render(const scene::Scene& asked, const FrameRequest& request) {
  assert(request.size.x > 0 && request.size.y > 0 && request.supersampling >= 1);
  assert(asked.surfaces.front().value && asked.camera.eye && asked.camera.target && asked.camera.up);
  using Clock = std::chrono::steady_clock;
  Parts& parts = *parts_;
  const scene::Scene& scene = parts.completed(asked, request);
  const Clock::time_point begin = Clock::now();
  const std::size_t errorsBefore = glErrors().size();
  parts.frame.gl->setKnownState();
  parts.report = {};
  try {
    parts.prepare(scene, request);
    parts.plan();
    parts.draw();
  } catch (const base::Error& error) {
    parts.leave(error.kind() == base::ErrorKind::interrupted);
    throw;
  } catch (...) {
    parts.leave(false);
    throw;
  }
  parts.writeReport();
  parts.endFrame();
  parts.frame.images.dropFree();
  parts.report.milliseconds = 1000.0 * base::secondsSince(begin);
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
  return parts_->budgetOfImages();
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

gi::VisiblePointSet Renderer::hitVoxels() {
  return render::hitVoxels(parts_->frame, parts_->drawn);
}

std::map<std::string, std::uint64_t> Renderer::imageHashes() {
  const FrameState& frame = parts_->frame;
  std::map<std::string, base::Hasher> hashes;
  for (const PlannedPass& pass : parts_->planned) {
    if (pass.state == PassState::skipped) continue;
    for (const std::string& image : parts_->declared[pass.index].writes) {
      // With Hessians, the gradients are the first image of theirs.
      if (!frame.images.has(image) || (frame.gradientShared && image == image::gradient)) continue;
      for (const Texture& texture : frame.images.at(image).images)
        for (const float value : texture.readFloats(4)) hashes[parts_->declared[pass.index].name].add(value);
    }
  }
  return {hashes.begin(), hashes.end()};
}

}  // namespace isolux::render
