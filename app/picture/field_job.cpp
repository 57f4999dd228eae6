#include "app/picture/field_job.h"

#include <utility>

#include "app/picture/rest_scene.h"
#include "app/process/caught_error.h"
#include "scene/rules/needs.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::app {

namespace {

using scene::Field;

bool isComplete(const scene::Derivatives& derivatives) {
  return derivatives.noise && derivatives.scale && derivatives.normalScale;
}

// What is read of it, and made.
bool sameSecondVolume(const scene::ColorVolume& a, const scene::ColorVolume& b) {
  return a.volume == b.volume && a.raw == b.raw && a.component == b.component && a.timeStep == b.timeStep &&
         a.field == b.field;
}

// The look reads derivatives of which something is to be chosen.
bool awaitsChoice(const scene::Scene& scene) {
  return scene::needsGradient(scene) && !isComplete(scene.derivatives);
}

// Deferred images read curvature, whatever the look.
scene::Scene withImages(scene::Scene scene) {
  scene.look.mode = scene::LookMode::kappa1;
  return scene;
}

// Of two scales, that which is asked for where its field is there, else the one before where that still is.
double readyScale(const volume::CubicFields& fields, Field field, double wanted, double before) {
  if (wanted == 0.0) return 0.0;
  for (const double scale : {wanted, before})
    if (scale > 0.0 && fields.find(field, scale)) return scale;
  return 0.0;
}

// Replaces scales that are not known, or whose fields are not there.
void takeReadyScales(scene::Scene& scene, const volume::CubicFields& fields, const scene::Derivatives& last) {
  scene::Derivatives& now = scene.derivatives;
  const auto ready = [&](std::optional<double>& scale, const std::optional<double>& before) {
    const double known = last.field == now.field ? before.value_or(0.0) : 0.0;
    scale = readyScale(fields, now.field, scale.value_or(known), known);
  };
  if (scene::needsGradient(scene)) ready(now.normalScale, last.normalScale);
  if (scene::needsSecondDerivatives(scene)) ready(now.scale, last.scale);
  // Nothing is left to be chosen while the picture is drawn.
  now.scale = now.scale.value_or(0.0);
  now.normalScale = now.normalScale.value_or(0.0);
}

}  // namespace

void completeFields(scene::Scene& resolved, const volume::PreparedVolume& volume, bool images,
                    base::Progress& progress) {
  if (awaitsChoice(images ? withImages(resolved) : resolved))
    volume.derivativeChoices->complete(resolved, progress);
  volume.cubicFields->makeFor(images ? withImages(resolved) : resolved, progress);
  volume::hiddenOf(resolved, *volume.pieces, progress);
  if (images || scene::showsSecondVolume(resolved)) volume.secondVolumes->make(resolved.color, progress);
}

bool fieldsAreReady(const scene::Scene& resolved, const volume::PreparedVolume& volume) {
  scene::Scene scene = resolved;
  if (awaitsChoice(scene) && !volume.derivativeChoices->completeIfChosen(scene)) return false;
  const bool colored = !scene::showsSecondVolume(scene) || volume.secondVolumes->find(scene.color);
  return colored && volume.cubicFields->readyFor(scene) && restIsReady(scene, volume) &&
         volume::hiddenIsReady(scene, *volume.pieces);
}

scene::Scene withReadyFields(scene::Scene resolved, const volume::PreparedVolume& volume,
                             const scene::Derivatives& last) {
  const volume::CubicFields& fields = *volume.cubicFields;
  scene::Derivatives& now = resolved.derivatives;
  if (awaitsChoice(resolved) && !volume.derivativeChoices->completeIfChosen(resolved))
    now.noise = now.noise.value_or(last.noise.value_or(0.0));
  if (!volume::hiddenIsReady(resolved, *volume.pieces)) resolved.pieces = {};
  if (resolved.hit.field != Field::trilinear && !fields.find(resolved.hit.field))
    resolved.hit.field = Field::trilinear;
  const scene::Derivatives wanted = now;
  takeReadyScales(resolved, fields, last);
  const bool unscaled = scene::readsUnscaled(resolved) || !scene::needsGradient(resolved);
  if (now.field == Field::cubic_interpolating && unscaled && !fields.find(now.field)) {
    now = wanted;
    now.field = Field::cubic;
    takeReadyScales(resolved, fields, last);
  }
  return resolved;
}

FieldJob::FieldJob(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& scene)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->volume = std::move(volume);
            work->scene = scene;
            return work;
          }(),
          run) {}

FieldJob::~FieldJob() {
  work_->progress.requestStop();
}

bool FieldJob::isFor(const scene::Scene& scene) const {
  const scene::Scene& own = work_->scene;
  const bool same = own.hit.field == scene.hit.field && own.derivatives == scene.derivatives &&
                    scene::needsGradient(own) == scene::needsGradient(scene) &&
                    scene::needsSecondDerivatives(own) == scene::needsSecondDerivatives(scene);
  const bool sameColor = scene::showsSecondVolume(own) == scene::showsSecondVolume(scene) &&
                         (!scene::showsSecondVolume(scene) || sameSecondVolume(own.color, scene.color));
  const bool sameAtRest = own.picture.restHits == scene.picture.restHits &&
                          scene::mayRefineHits(own) == scene::mayRefineHits(scene);
  const bool samePieces = own.pieces == scene.pieces;
  const bool measures = awaitsChoice(scene) || scene::mayRefineHits(scene);
  return same && sameColor && sameAtRest && samePieces &&
         (!measures || own.isosurface.value == scene.isosurface.value);
}

void FieldJob::run(Work& work) {
  work.error = caughtError(work.volume->volume.name, "make the field", [&] {
    scene::Scene scene = work.scene;
    completeFields(scene, *work.volume, false, work.progress);
    atRest(std::move(scene), *work.volume, work.progress);
  });
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
