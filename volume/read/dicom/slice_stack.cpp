#include "volume/read/dicom/slice_stack.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "base/quantiles.h"
#include "volume/read/input/image_header.h"
#include "volume/read/input/spacing_reliability.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr double samePositionMm = 1e-3;
constexpr double silentUnevenness = 0.01, toleratedUnevenness = 0.1;  // of the slice distance
constexpr double silentLateral = 0.1, toleratedLateral = 0.5;         // of a pixel
constexpr double widestFill = 4.0;                                    // times as many slices at most

std::string fourDigits(double value) {  // of measurements, for people
  return base::shortText(value, 4);
}

// Time steps of slices at the same positions. `stack.order` is sorted by position.
void separateTimeSteps(const SlicePlanes& planes, const std::vector<double>& along, SliceStack& stack,
                       const std::string& file) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t slice : stack.order) {
    if (groups.empty() || along[slice] - along[groups.back().front()] > samePositionMm)
      groups.push_back({slice});
    else
      groups.back().push_back(slice);
  }
  for (auto& group : groups) std::ranges::sort(group);  // as given, not by their last digits
  TimeSteps steps = separateRepeats(groups, planes.tags);
  if (steps.count > 1 && groups.size() == 1 && !steps.stated)
    throwInput(file, "slice positions",
               "all " + std::to_string(steps.count) + " slices have the same position");
  stack.order = std::move(steps.order);
  stack.timeSteps = steps.count;
  stack.warnings = std::move(steps.warnings);
}

bool sameDistance(double a, double b) {
  return std::abs(a - b) <= toleratedUnevenness * std::max(a, b);
}

// Distances that hold for a while, as a series of several blocks has them; empty where a single gap is wider
// than those of the blocks beside it. A narrower one is where two blocks meet or overlap.
std::vector<double> blocksOf(const std::vector<double>& gaps) {
  struct Run {
    double distance;
    std::size_t length;
  };
  std::vector<Run> runs;
  for (const double gap : gaps) {
    if (!runs.empty() && sameDistance(gap, runs.back().distance))
      ++runs.back().length;
    else
      runs.push_back({gap, 1});
  }
  std::vector<double> blocks;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].length > 1) {
      if (blocks.empty() || !sameDistance(blocks.back(), runs[i].distance))
        blocks.push_back(runs[i].distance);
      continue;
    }
    if (i == 0 || i + 1 == runs.size()) return {};
    if (runs[i].distance > std::max(runs[i - 1].distance, runs[i + 1].distance)) return {};
  }
  return blocks;
}

// What distances well above the median mean: another distance for a part of the series, or missing slices.
std::string wideGapsText(const std::vector<double>& gaps, double median) {
  const auto wide = std::ranges::count_if(gaps, [&](double gap) { return gap > 1.5 * median; });
  if (wide == 0) return {};
  if (const std::vector<double> blocks = blocksOf(gaps); blocks.size() > 1 && blocks.size() < 6) {
    std::string text = "slice distance changes from " + fourDigits(blocks[0]);
    for (std::size_t i = 1; i < blocks.size(); ++i) text += " to " + fourDigits(blocks[i]);
    return text + " mm";
  }
  return std::string(kSlicesMissing) + std::to_string(wide) + (wide == 1 ? " place" : " places") +
         "; these are interpolated";
}

}  // namespace

SliceStack stackSlices(const SlicePlanes& planes, const std::string& file) {
  SliceStack stack;
  const auto& positions = planes.positionsMm;
  const glm::dvec3 normal = glm::normalize(glm::cross(planes.rowDirection, planes.columnDirection));
  std::vector<double> along(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    along[i] = glm::dot(positions[i], normal);
    if (!std::isfinite(along[i]))
      throwInput(file, "slice positions", "a position or direction is not finite");
  }
  stack.order.resize(positions.size());
  std::iota(stack.order.begin(), stack.order.end(), std::size_t{0});
  std::ranges::stable_sort(stack.order, [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
  separateTimeSteps(planes, along, stack, file);

  const std::size_t count = stack.sourceSlices();
  const glm::dvec3 first = positions[stack.order[0]], last = positions[stack.order[count - 1]];
  const double begin = along[stack.order[0]], length = along[stack.order[count - 1]] - begin;
  glm::dvec3 perMm = normal;  // how far the first voxel moves for 1 mm along the normal
  double distance = planes.thicknessMm;
  if (count == 1 && !(distance > 0.0)) {
    stack.warnings.push_back("SliceThickness is missing or not positive; " + std::string(kSpacingAssumed));
    distance = 1.0;
  }
  std::vector<double> gaps;
  double median = distance;
  if (count > 1) {
    perMm = (last - first) / length;
    for (std::size_t i = 1; i < count; ++i) gaps.push_back(along[stack.order[i]] - along[stack.order[i - 1]]);
    std::vector<double> inAnyOrder = gaps;
    median = base::quantile(inAnyOrder, 0.5);
    distance = length / static_cast<double>(count - 1);
  }

  const double stated = std::abs(planes.distanceMm);
  if (count > 1 && stated > 0.0 && std::abs(stated - median) > toleratedUnevenness * median)
    stack.warnings.push_back("SpacingBetweenSlices states " + fourDigits(stated) + " mm, the positions " +
                             fourDigits(median) + " mm; the positions are used");

  double lateral = 0.0, uneven = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t slice = stack.order[i];
    const double at = along[slice] - begin;
    lateral = std::max(lateral, glm::length(positions[slice] - (first + perMm * at)));
    uneven = std::max(uneven, std::abs(at - static_cast<double>(i) * distance));
  }
  const double pixel = std::min(planes.spacingXMm, planes.spacingYMm);
  if (lateral > toleratedLateral * pixel)
    throwInput(file, "slice positions",
               "the slices are not on one line: one is " + fourDigits(lateral) + " mm off");
  if (lateral > silentLateral * pixel)
    stack.warnings.push_back("a slice is " + fourDigits(lateral) + " mm off the line of the others");

  if (uneven > toleratedUnevenness * median) {
    const auto [least, most] = std::ranges::minmax_element(gaps);
    const double wanted = std::round(length / median) + 1.0;
    if (wanted > widestFill * static_cast<double>(count) || wanted > 65535.0)
      throwInput(file, "slice positions",
                 "slice distances from " + fourDigits(*least) + " to " + fourDigits(*most) +
                     " mm: too much is missing to fill a regular grid");
    const auto slices = static_cast<std::size_t>(std::max(wanted, 2.0));
    distance = length / static_cast<double>(slices - 1);
    std::size_t source = 0;
    for (std::size_t k = 0; k < slices; ++k) {
      const double at = std::min(static_cast<double>(k) * distance, length);
      while (source + 2 < count && along[stack.order[source + 1]] - begin <= at) ++source;
      const double fraction = (at - (along[stack.order[source]] - begin)) / gaps[source];
      stack.resampled.push_back({source, std::clamp(fraction, 0.0, 1.0)});
    }
    stack.warnings.push_back("slice distances are uneven (" + fourDigits(*least) + " to " +
                             fourDigits(*most) + " mm): " + std::string(kSlicesResampled) + " from " +
                             std::to_string(count) + " onto " + std::to_string(slices) + " slices every " +
                             fourDigits(distance) + " mm");
    if (const std::string gapsText = wideGapsText(gaps, median); !gapsText.empty())
      stack.warnings.push_back(gapsText);
  } else if (uneven > silentUnevenness * median) {
    stack.warnings.push_back("slice positions deviate by up to " + fourDigits(uneven) +
                             " mm from even distances; taken as even");
  }

  const double tilt = std::acos(std::min(1.0, 1.0 / glm::length(perMm))) * 180.0 / 3.14159265358979323846;
  if (tilt > 0.1)
    stack.warnings.push_back(
        "gantry tilt of " + fourDigits(tilt) +
        " degrees: the slices are sheared against each other; kept so, the grid is oblique");
  stack.worldFromVoxel[0] = glm::dvec4(planes.rowDirection * planes.spacingXMm, 0.0);
  stack.worldFromVoxel[1] = glm::dvec4(planes.columnDirection * planes.spacingYMm, 0.0);
  stack.worldFromVoxel[2] = glm::dvec4(perMm * distance, 0.0);
  stack.worldFromVoxel[3] = glm::dvec4(first, 1.0);
  if (!usableAffine(stack.worldFromVoxel))
    throwInput(file, "slice positions", "spacing or orientation is degenerate");
  return stack;
}

}  // namespace isolux::volume
