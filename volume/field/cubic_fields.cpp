#include "volume/field/cubic_fields.h"

#include "volume/prepared_volume.h"

namespace isolux::volume {

namespace {

CubicField made(const Grid& grid, scene::Field field, base::Progress& progress) {
  if (field == scene::Field::cubic) {
    progress.report(0.0, "building blocks");
    MinMaxBlocks blocks = MinMaxBlocks::ofCubic(grid, kBlockCells, progress);
    return {std::nullopt, std::move(blocks), BoxBounds::ofCubic(grid, progress)};
  }
  Coefficients coefficients = interpolatingCoefficients(grid, progress);
  MinMaxBlocks blocks = MinMaxBlocks::ofCubic(coefficients, grid, kBlockCells, progress);
  BoxBounds boxes = BoxBounds::ofCubic(coefficients, grid, progress);
  return {std::move(coefficients), std::move(blocks), std::move(boxes)};
}

// The fields of a scene for which something must be made.
template <class Visit>
void forEachNeeded(const scene::Scene& scene, const Visit& visit) {
  if (scene.hit.field != scene::Field::trilinear) visit(scene.hit.field);
  if (scene.derivatives.field == scene::Field::cubic_interpolating &&
      scene.hit.field != scene.derivatives.field)
    visit(scene.derivatives.field);
}

}  // namespace

std::shared_ptr<const CubicField> CubicFields::find(scene::Field field) const {
  if (field == scene::Field::trilinear) return nullptr;
  const std::lock_guard lock(mutex_);
  return field == scene::Field::cubic ? cubic_ : interpolating_;
}

std::shared_ptr<const CubicField> CubicFields::make(scene::Field field, base::Progress& progress) {
  if (field == scene::Field::trilinear) return nullptr;
  if (auto there = find(field)) return there;
  auto fresh = std::make_shared<const CubicField>(made(*grid_, field, progress));
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const CubicField>& slot = field == scene::Field::cubic ? cubic_ : interpolating_;
  if (!slot) slot = std::move(fresh);
  return slot;
}

bool CubicFields::readyFor(const scene::Scene& scene) const {
  bool ready = true;
  forEachNeeded(scene, [&](scene::Field field) { ready = ready && find(field) != nullptr; });
  return ready;
}

void CubicFields::makeFor(const scene::Scene& scene, base::Progress& progress) {
  forEachNeeded(scene, [&](scene::Field field) { make(field, progress); });
}

}  // namespace isolux::volume
