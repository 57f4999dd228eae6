// Provides the names of enumeration values as used after --set and in sessions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "scene/choices.h"
#include "scene/looks.h"
#include "scene/settings/host_settings.h"

namespace isolux::scene {

// The names of all values of an enumeration, in their order, which is that in which users see them.
template <class Choice>
struct ChoiceNames {
  template <class... Names>
  explicit constexpr ChoiceNames(Names... names) : list{names...}, count(sizeof...(names)) {}
  std::string_view list[9];
  std::size_t count;
};
inline constexpr std::tuple kChoiceNames{
    ChoiceNames<DataKind>("auto", "ct_hu", "ct", "mr", "microscopy", "simulation", "distance", "labels",
                          "other"),
    ChoiceNames<Csg>("none", "union", "intersection", "difference", "blend"),
    ChoiceNames<Frames>("surface", "volume"),
    ChoiceNames<Suggestion>("object", "contrast"),
    ChoiceNames<Inside>("above", "below"),
    ChoiceNames<HitMethod>("sampled", "exact"),
    ChoiceNames<Field>("trilinear", "cubic", "cubic_interpolating"),
    ChoiceNames<StillField>("auto", "same", "cubic_interpolating"),
    ChoiceNames<Fetch>("fast", "exact"),
    ChoiceNames<Shading>("unlit", "lambert", "blinn_phong", "tone", "gi"),
    ChoiceNames<SolidTexture>("none", "marble", "wood", "checker"),
    ChoiceNames<ColorMap>("auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange",
                          "purple_green", "spectral"),
    ChoiceNames<LengthUnit>("pixels", "mm"),
    ChoiceNames<LegendCorner>("auto", "lower_right", "lower_left", "upper_right", "upper_left"),
    ChoiceNames<FlowDirection>("maximum", "minimum"),
    ChoiceNames<LightSetup>("three_point", "key"),
    ChoiceNames<LightSpace>("camera", "world"),
    ChoiceNames<AlbedoSource>("color", "map"),
    ChoiceNames<BuiltInLight>("studio", "window", "overcast", "sunset", "dark_studio"),
    ChoiceNames<ClipCap>("none", "inside", "whole"),
    ChoiceNames<SlabMode>("mean", "maximum", "minimum"),
    ChoiceNames<Convention>("radiological", "neurological"),
    ChoiceNames<MarkKind>("point", "distance", "path", "angle", "circle", "thickness", "piece"),
    ChoiceNames<Metering>("surface", "lights", "brightness"),
    ChoiceNames<ToneCurve>("auto", "linear", "filmic"),
    ChoiceNames<WorkOverlay>("none", "blocks", "bricks", "texels"),
    ChoiceNames<LampKind>("point", "directional", "sphere"),
    ChoiceNames<GiMode>("auto", "off", "irradiance", "transfer", "vicinity", "shadow"),
    ChoiceNames<GiExtent>("full", "band", "view"),
    ChoiceNames<GiTexels>("auto", "own", "shown"),
    ChoiceNames<DirectionSequence>("sobol_owen", "r2", "random"),
    ChoiceNames<GiInterpolation>("closest_isovalue", "nearest", "trilinear", "tricubic", "weighted"),
    ChoiceNames<GiPrecision>("r11g11b10", "half"),
    ChoiceNames<Projection>("perspective", "orthographic"),
    ChoiceNames<MemoryLayout>("auto", "whole", "bricks"),
    ChoiceNames<VoxelPlace>("auto", "memory", "file"),
    ChoiceNames<Canvas>("auto", "textures", "pixels"),
    ChoiceNames<Executor>("auto", "gpu", "cpu")};

// Returns the names of all values of an enumeration of scene/choices.h or scene/settings/host_settings.h.
template <class T>
std::span<const std::string_view> choiceNames() {
  const auto& names = std::get<ChoiceNames<T>>(kChoiceNames);
  return {names.list, names.count};
}
template <>
inline std::span<const std::string_view> choiceNames<LookMode>() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const LookInfo& look : looks()) list.push_back(look.name);
    return list;
  }();
  return names;
}

template <class T>
std::string_view choiceName(T value) {
  return choiceNames<T>()[static_cast<std::size_t>(value)];
}

// Returns nullopt if no value has that name.
template <class T>
std::optional<T> choiceNamed(std::string_view name) {
  const std::span<const std::string_view> names = choiceNames<T>();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<T>(found - names.begin());
}

}  // namespace isolux::scene
