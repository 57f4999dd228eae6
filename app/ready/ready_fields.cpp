#include "app/ready/ready_fields.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/ready/rest_scene.h"
#include "scene/rules/needs.h"

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

// The field of a surface of labels, and what pictures need of it, are there.
bool isReady(const volume::PreparedVolume& field, const scene::Scene& scene) {
  return field.cubicFields->readyFor(scene) && volume::hiddenIsReady(scene, *field.pieces);
}

bool labelsAreReady(const scene::Scene& scene, const volume::PreparedVolume& volume) {
  if (!volume.labelSurfaces) return true;
  const auto fields = volume.labelSurfaces->find(scene, *volume.labels);
  return fields &&
         std::ranges::all_of(*fields, [&](const auto& field) { return !field || isReady(*field, scene); });
}

// Until they are: those that are there, or one surface of all labels.
void leaveOutUnready(scene::Scene& scene, const volume::PreparedVolume& volume) {
  const volume::LabelSurfaces::Fields fields = volume.labelSurfaces->findEach(scene, *volume.labels);
  bool any = false;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    scene::Surface& surface = scene.surfaces[i];
    surface.shown = surface.shown && fields[i] && isReady(*fields[i], scene);
    any = any || (surface.shown && surface.opacity > 0.0);
  }
  if (any) return;
  scene.surfaces.resize(1);
  scene.surfaces.front() = {
      .id = scene.surfaces.front().id, .value = 0.0, .albedo = scene.surfaces.front().albedo};
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
  for (const auto& field : volume::labelFields(volume, resolved, progress)) {
    if (!field) continue;
    field->cubicFields->makeFor(images ? withImages(resolved) : resolved, progress);
    volume::hiddenOf(resolved, *field->pieces, progress);
  }
  if (images || scene::showsSecondVolume(resolved)) volume.secondVolumes->make(resolved.color, progress);
}

bool fieldsAreReady(const scene::Scene& resolved, const volume::PreparedVolume& volume) {
  scene::Scene scene = resolved;
  if (awaitsChoice(scene) && !volume.derivativeChoices->completeIfChosen(scene)) return false;
  const bool colored = !scene::showsSecondVolume(scene) || volume.secondVolumes->find(scene.color);
  return colored && labelsAreReady(scene, volume) && volume.cubicFields->readyFor(scene) &&
         restIsReady(scene, volume) && volume::hiddenIsReady(scene, *volume.pieces);
}

scene::Scene withReadyFields(scene::Scene resolved, const volume::PreparedVolume& volume,
                             const scene::Derivatives& last) {
  const volume::CubicFields& fields = *volume.cubicFields;
  scene::Derivatives& now = resolved.derivatives;
  if (awaitsChoice(resolved) && !volume.derivativeChoices->completeIfChosen(resolved))
    now.noise = now.noise.value_or(last.noise.value_or(0.0));
  if (!volume::hiddenIsReady(resolved, *volume.pieces)) resolved.pieces = {};
  if (!labelsAreReady(resolved, volume)) leaveOutUnready(resolved, volume);
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

std::unique_ptr<FieldTask> fieldTask(std::shared_ptr<const volume::PreparedVolume> volume,
                                     scene::Scene resolved) {
  const std::string file = volume->volume.name;
  const auto work = [volume = std::move(volume), resolved = std::move(resolved)](base::Progress& progress) {
    scene::Scene scene = resolved;
    completeFields(scene, *volume, false, progress);
    atRest(std::move(scene), *volume, progress);
  };
  return FieldTask::start({file, "make the field"}, work);
}

bool needSameFields(const scene::Scene& a, const scene::Scene& b) {
  const bool same = a.hit.field == b.hit.field && a.derivatives == b.derivatives &&
                    scene::needsGradient(a) == scene::needsGradient(b) &&
                    scene::needsSecondDerivatives(a) == scene::needsSecondDerivatives(b);
  const bool sameColor = scene::showsSecondVolume(a) == scene::showsSecondVolume(b) &&
                         (!scene::showsSecondVolume(b) || sameSecondVolume(a.color, b.color));
  const bool sameAtRest =
      a.picture.restHits == b.picture.restHits && scene::mayRefineHits(a) == scene::mayRefineHits(b);
  const bool measures = awaitsChoice(b) || scene::mayRefineHits(b);
  const auto sameLabels = [](const scene::Surface& x, const scene::Surface& y) {
    return x.labels == y.labels && x.smoothing == y.smoothing && x.shown == y.shown;
  };
  return same && sameColor && sameAtRest && std::ranges::equal(a.surfaces, b.surfaces, sameLabels) &&
         a.pieces == b.pieces && (!measures || a.surfaces.front().value == b.surfaces.front().value);
}

}  // namespace isolux::app
