#include "volume/derived/cubic_fields.h"

#include <algorithm>

#include "scene/rules/needs.h"

namespace isolux::volume {

namespace {

CubicField made(const Grid& grid, scene::Field field, base::Progress& progress) {
  std::shared_ptr<const Coefficients> coefficients;
  if (field == scene::Field::cubic)
    progress.report(0.0, "building blocks");
  else
    coefficients = std::make_shared<const Coefficients>(interpolatingCoefficients(grid, progress));
  MinMaxBlocks blocks = MinMaxBlocks::ofCubic(grid, coefficients.get(), kBlockCells, progress);
  BoxBounds boxes = BoxBounds::ofCubic(grid, coefficients.get(), progress);
  return {std::move(coefficients), std::move(blocks), std::move(boxes)};
}

// The scales that derivatives of the scene are read at, mm; 0 is none.
std::vector<double> scalesOf(const scene::Scene& scene) {
  std::vector<double> scales;
  if (scene::needsSecondDerivatives(scene)) scales.push_back(scene.derivatives.scale.value_or(0.0));
  if (scene::needsGradient(scene)) scales.push_back(scene.derivatives.normalScale.value_or(0.0));
  return scales;
}

// Calls visit(field) and visitScaled(field, scaleMm) for what must be made of a scene.
template <class Visit, class VisitScaled>
void forEachNeeded(const scene::Scene& scene, const Visit& visit, const VisitScaled& visitScaled) {
  const scene::Field derived = scene.derivatives.field;
  if (scene.hit.field != scene::Field::trilinear) visit(scene.hit.field);
  if (scene::showsCutFaces(scene) && scene.slice.field == scene::Field::cubic_interpolating)
    visit(scene.slice.field);
  if (derived == scene::Field::trilinear) return;
  const std::vector<double> scales = scalesOf(scene);
  const bool atNone = scales.empty() || std::find(scales.begin(), scales.end(), 0.0) != scales.end();
  if (derived == scene::Field::cubic_interpolating && atNone && scene.hit.field != derived) visit(derived);
  for (const double scale : scales)
    if (scale > 0.0) visitScaled(derived, scale);
}

}  // namespace

std::shared_ptr<const CubicField> CubicFields::find(scene::Field field) const {
  if (field == scene::Field::trilinear) return nullptr;
  return (field == scene::Field::cubic ? cubic_ : interpolating_).find({}).value_or(nullptr);
}

std::shared_ptr<const CubicField> CubicFields::make(scene::Field field, base::Progress& progress) {
  if (field == scene::Field::trilinear) return nullptr;
  const auto make = [&] { return std::make_shared<const CubicField>(made(*grid_, field, progress)); };
  return (field == scene::Field::cubic ? cubic_ : interpolating_).get({}, [&] {
    return base::madeWithRoom(make, [this] { return scaled_.forgetOldest(); });
  });
}

std::shared_ptr<const ScaledField> CubicFields::find(scene::Field field, double scaleMm) const {
  return scaled_.find({field, scaleMm}).value_or(nullptr);
}

std::shared_ptr<const ScaledField> CubicFields::make(scene::Field field, double scaleMm,
                                                     base::Progress& progress) {
  if (field == scene::Field::trilinear || !(scaleMm > 0.0)) return nullptr;
  return scaled_.get({field, scaleMm}, [&] {
    return std::make_shared<const ScaledField>(scaledField(*grid_, field, scaleMm, progress));
  });
}

bool CubicFields::readyFor(const scene::Scene& scene) const {
  bool ready = true;
  forEachNeeded(
      scene, [&](scene::Field field) { ready = ready && find(field) != nullptr; },
      [&](scene::Field field, double scaleMm) { ready = ready && find(field, scaleMm) != nullptr; });
  return ready;
}

void CubicFields::makeFor(const scene::Scene& scene, base::Progress& progress) {
  forEachNeeded(
      scene, [&](scene::Field field) { make(field, progress); },
      [&](scene::Field field, double scaleMm) { make(field, scaleMm, progress); });
}

}  // namespace isolux::volume
