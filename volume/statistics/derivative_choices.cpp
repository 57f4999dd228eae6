// Stand-in: chooses no scale. The real one comes with the research on scales.
#include "volume/statistics/derivative_choices.h"

#include "volume/statistics/noise_estimate.h"

namespace isolux::volume {

scene::NoiseModel DerivativeChoices::noise(base::Progress& progress) const {
  {
    const std::lock_guard lock(mutex_);
    if (noise_) return *noise_;
  }
  scene::NoiseModel model = estimateNoise(*grid_, progress);
  const std::lock_guard lock(mutex_);
  noise_ = model;
  return model;
}

std::optional<DerivativeChoice> DerivativeChoices::find(double isovalue, scene::Field field) const {
  const std::lock_guard lock(mutex_);
  for (const Kept& kept : kept_)
    if (kept.isovalue == isovalue && kept.field == field) return kept.choice;
  return std::nullopt;
}

DerivativeChoice DerivativeChoices::choose(double isovalue, scene::Field field,
                                           base::Progress& progress) const {
  if (const auto there = find(isovalue, field)) return *there;
  DerivativeChoice choice;
  choice.noise = noise(progress).at(isovalue);
  choice.noiseReason = "measured over the whole volume";
  choice.scaleReason = choice.normalReason = "nothing is chosen yet";
  const std::lock_guard lock(mutex_);
  kept_.push_back({isovalue, field, choice});
  return choice;
}

bool DerivativeChoices::completeIfChosen(scene::Scene& scene) const {
  const auto choice = find(scene.isosurface.value.value(), scene.derivatives.field);
  if (!choice) return false;
  scene::Derivatives& to = scene.derivatives;
  to.noise = to.noise.value_or(choice->noise);
  to.scale = to.scale.value_or(choice->scaleMm);
  to.normalScale = to.normalScale.value_or(choice->normalScaleMm);
  return true;
}

void DerivativeChoices::complete(scene::Scene& scene, base::Progress& progress) const {
  scene::Derivatives& to = scene.derivatives;
  if (to.noise && to.scale && to.normalScale) return;
  choose(scene.isosurface.value.value(), to.field, progress);
  completeIfChosen(scene);
}

}  // namespace isolux::volume
