#include "volume/statistics/data_kind.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "volume/grid.h"
#include "volume/labels/label_table.h"

namespace isolux::volume {

namespace {

// The part of all voxels with values in [low, high).
double share(const Histogram& histogram, double low, double high) {
  double inside = 0.0, all = 0.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const auto count = static_cast<double>(histogram.counts[bin]);
    const double value = histogram.binCentre(bin);
    all += count;
    if (low <= value && value < high) inside += count;
  }
  return all > 0.0 ? inside / all : 0.0;
}

// Programs that know nothing of a patient write such files too: unit voxels round the origin.
bool isBoxRoundTheOrigin(const GridGeometry& geometry) {
  const glm::dmat4& m = geometry.worldFromVoxel;
  const glm::dvec3 middle(m * glm::dvec4(0.5 * glm::dvec3(geometry.dims - 1), 1.0));
  bool alongAxes = true;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      alongAxes = alongAxes && std::abs(m[column][row]) == (row == column ? 1.0 : 0.0);
  return alongAxes && glm::all(glm::lessThanEqual(glm::abs(middle), glm::dvec3(1.5)));
}

}  // namespace

bool looksOffsetBy1024(const Histogram& histogram, double minimum) {
  constexpr double enough = 0.05;
  const double air = share(histogram, 0.0, 150.0), between = share(histogram, 250.0, 750.0),
               tissue = share(histogram, 900.0, 1200.0);
  return minimum >= 0.0 && air >= enough && tissue >= enough && between < tissue;
}

std::optional<double> softTissueOf(const Histogram& histogram) {
  constexpr double within = 0.05, enough = 0.4;
  const std::vector<std::uint64_t>& counts = histogram.counts;
  if (counts.empty()) return std::nullopt;
  const auto width = static_cast<std::size_t>(within * static_cast<double>(counts.size()));
  const auto air =
      static_cast<std::size_t>(std::distance(counts.begin(), std::max_element(counts.begin(), counts.end())));
  double rest = 0.0, most = 0.0, inPeak = 0.0;
  std::size_t at = 0;
  for (std::size_t bin = air + width; bin < counts.size();
       ++bin) {  // beside air lie its noise and its borders
    rest += static_cast<double>(counts[bin]);
    inPeak += static_cast<double>(counts[bin]);
    if (bin >= air + 2 * width) inPeak -= static_cast<double>(counts[bin - width]);
    if (inPeak > most) {
      most = inPeak;
      at = bin - width / 2;
    }
  }
  // Bone is as far above soft tissue as that is above air, or farther.
  constexpr double highest = 0.5;
  const bool low = static_cast<double>(at - air) < highest * static_cast<double>(counts.size() - air);
  if (rest <= 0.0 || most < enough * rest || !low) return std::nullopt;
  return histogram.binCentre(at);
}

FoundKind dataKindOf(const Volume& volume, const Histogram& histogram, const scene::NoiseModel& noise) {
  using Kind = scene::DataKind;
  const Grid& grid = *volume.grid;
  const bool patient = volume.axes == scene::WorldAxes::anatomical;
  const glm::dvec2 hounsfield(0.0, 1.0);
  const auto byTissue = [&]() -> std::optional<glm::dvec2> {
    constexpr double airHu = -1000.0, tissueHu = 40.0;
    const std::optional<double> tissue = softTissueOf(histogram);
    if (!tissue) return std::nullopt;
    const double perHu = (*tissue - grid.minimum()) / (tissueHu - airHu);
    return glm::dvec2(grid.minimum() - perHu * airHu, perHu);
  };
  if (volume.kind != Kind::automatic) {
    FoundKind asked{volume.kind, "source.kind is set"};
    if (asked.kind == Kind::ct_hu) asked.hounsfield = hounsfield;
    if (asked.kind == Kind::ct) asked.hounsfield = byTissue();
    return asked;
  }
  if (statesLabels(volume.labelTable.get())) return {Kind::labels, volume.labelTable->reason};
  if (volume.labels > 0) return {Kind::labels, "its values are few whole numbers that fill regions"};
  if (volume.unit == "HU") return {Kind::ct_hu, "its file states it", hounsfield};
  if (volume.isMesh) return {Kind::distance, "it was made from a mesh"};
  if (volume.unit == "mm") return {Kind::distance, "its values are in mm"};
  if (!volume.unit.empty()) return {Kind::other, "its values are in " + volume.unit};
  if (grid.storedType() == VoxelType::int16 && grid.minimum() >= -3100.0 && grid.minimum() <= -900.0 &&
      grid.maximum() > 500.0)
    return {Kind::ct_hu, "its data range is that of a CT", hounsfield};
  if (patient) {
    if (const auto scale = byTissue())
      return {Kind::ct, "most of its voxels have the value of soft tissue, as in a CT", scale};
    if (!isBoxRoundTheOrigin(grid.geometry()))
      return {Kind::mr, "it is a scan of a patient, and its values are not those of a CT"};
  }
  constexpr double smallestMm = 0.002;
  if (grid.geometry().leastSpacingMm() < smallestMm)
    return {Kind::microscopy, "its voxels are smaller than 2 micrometres"};
  // Rounding is a noise of 0.29 of a step; floats have some, too, of which a millionth of their range is
  // none.
  const double rounding = grid.storedType() == VoxelType::float32 ? 1e-6 * (grid.maximum() - grid.minimum())
                                                                  : 0.5 * std::abs(grid.slope());
  const auto most = std::max_element(noise.deviations.begin(), noise.deviations.end());
  if (grid.isWhole() && most != noise.deviations.end() && *most <= rounding)
    return {Kind::simulation, "its values have no noise"};
  return {Kind::other, "there is no other evidence"};
}

}  // namespace isolux::volume
