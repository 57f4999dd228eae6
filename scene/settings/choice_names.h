// Provides the names of enumeration values as used after --set and in sessions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scene/choices.h"
#include "scene/looks.h"
#include "scene/settings/host_settings.h"

namespace isolux::scene {

// In the order of the values, which is the order in which users see them.
template <class T>
inline constexpr std::string_view kChoiceNames[] = {""};
template <>
inline constexpr std::string_view kChoiceNames<DataKind>[] = {
    "auto", "ct_hu", "ct", "mr", "microscopy", "simulation", "distance", "labels", "other"};
template <>
inline constexpr std::string_view kChoiceNames<Csg>[] = {"none", "union", "intersection", "difference",
                                                         "blend"};
template <>
inline constexpr std::string_view kChoiceNames<Frames>[] = {"surface", "volume"};
template <>
inline constexpr std::string_view kChoiceNames<Suggestion>[] = {"object", "contrast"};
template <>
inline constexpr std::string_view kChoiceNames<Inside>[] = {"above", "below"};
template <>
inline constexpr std::string_view kChoiceNames<HitMethod>[] = {"sampled", "exact"};
template <>
inline constexpr std::string_view kChoiceNames<Field>[] = {"trilinear", "cubic", "cubic_interpolating"};
template <>
inline constexpr std::string_view kChoiceNames<StillField>[] = {"auto", "same", "cubic_interpolating"};
template <>
inline constexpr std::string_view kChoiceNames<Fetch>[] = {"fast", "exact"};
template <>
inline constexpr std::string_view kChoiceNames<Shading>[] = {"unlit", "lambert", "blinn_phong", "tone", "gi"};
template <>
inline constexpr std::string_view kChoiceNames<SolidTexture>[] = {"none", "marble", "wood", "checker"};
template <>
inline constexpr std::string_view kChoiceNames<ColorMap>[] = {
    "auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"};
template <>
inline constexpr std::string_view kChoiceNames<LengthUnit>[] = {"pixels", "mm"};
template <>
inline constexpr std::string_view kChoiceNames<LegendCorner>[] = {"auto", "lower_right", "lower_left",
                                                                  "upper_right", "upper_left"};
template <>
inline constexpr std::string_view kChoiceNames<FlowDirection>[] = {"maximum", "minimum"};
template <>
inline constexpr std::string_view kChoiceNames<LightSetup>[] = {"three_point", "key"};
template <>
inline constexpr std::string_view kChoiceNames<LightSpace>[] = {"camera", "world"};
template <>
inline constexpr std::string_view kChoiceNames<AlbedoSource>[] = {"color", "map"};
template <>
inline constexpr std::string_view kChoiceNames<BuiltInLight>[] = {"studio", "window", "overcast", "sunset",
                                                                  "dark_studio"};
template <>
inline constexpr std::string_view kChoiceNames<ClipCap>[] = {"none", "inside", "whole"};
template <>
inline constexpr std::string_view kChoiceNames<SlabMode>[] = {"mean", "maximum", "minimum"};
template <>
inline constexpr std::string_view kChoiceNames<Convention>[] = {"radiological", "neurological"};
template <>
inline constexpr std::string_view kChoiceNames<MarkKind>[] = {"point",  "distance",  "path", "angle",
                                                              "circle", "thickness", "piece"};
template <>
inline constexpr std::string_view kChoiceNames<Metering>[] = {"surface", "lights", "brightness"};
template <>
inline constexpr std::string_view kChoiceNames<ToneCurve>[] = {"auto", "linear", "filmic"};
template <>
inline constexpr std::string_view kChoiceNames<WorkOverlay>[] = {"none", "blocks", "bricks", "texels"};
template <>
inline constexpr std::string_view kChoiceNames<LampKind>[] = {"point", "directional", "sphere"};
template <>
inline constexpr std::string_view kChoiceNames<GiMode>[] = {"auto",     "off",      "irradiance",
                                                            "transfer", "vicinity", "shadow"};
template <>
inline constexpr std::string_view kChoiceNames<GiExtent>[] = {"full", "band", "view"};
template <>
inline constexpr std::string_view kChoiceNames<GiTexels>[] = {"auto", "own", "shown"};
template <>
inline constexpr std::string_view kChoiceNames<DirectionSequence>[] = {"sobol_owen", "r2", "random"};
template <>
inline constexpr std::string_view kChoiceNames<GiInterpolation>[] = {"closest_isovalue", "nearest",
                                                                     "trilinear", "tricubic", "weighted"};
template <>
inline constexpr std::string_view kChoiceNames<GiPrecision>[] = {"r11g11b10", "half"};
template <>
inline constexpr std::string_view kChoiceNames<Projection>[] = {"perspective", "orthographic"};
template <>
inline constexpr std::string_view kChoiceNames<MemoryLayout>[] = {"auto", "whole", "bricks"};
template <>
inline constexpr std::string_view kChoiceNames<VoxelPlace>[] = {"auto", "memory", "file"};
template <>
inline constexpr std::string_view kChoiceNames<Canvas>[] = {"auto", "textures", "pixels"};
template <>
inline constexpr std::string_view kChoiceNames<Executor>[] = {"auto", "gpu", "cpu"};

// Returns the names of all values of an enumeration of scene/choices.h or scene/settings/host_settings.h.
template <class T>
std::span<const std::string_view> choiceNames() {
  return kChoiceNames<T>;
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
