#include "scene/settings/choice_names.h"

#include <vector>

#include "scene/looks.h"
#include "scene/settings/machine.h"

namespace isolux::scene {

template <>
std::span<const Named<DataKind>> choicesOf() {
  static constexpr Named<DataKind> names[] = {{DataKind::automatic, "auto"},
                                              {DataKind::ct_hu, "ct_hu"},
                                              {DataKind::ct, "ct"},
                                              {DataKind::mr, "mr"},
                                              {DataKind::microscopy, "microscopy"},
                                              {DataKind::simulation, "simulation"},
                                              {DataKind::distance, "distance"},
                                              {DataKind::labels, "labels"},
                                              {DataKind::other, "other"}};
  return names;
}

template <>
std::span<const Named<Csg>> choicesOf() {
  static constexpr Named<Csg> names[] = {{Csg::none, "none"},
                                         {Csg::unite, "union"},
                                         {Csg::intersection, "intersection"},
                                         {Csg::difference, "difference"},
                                         {Csg::blend, "blend"}};
  return names;
}

template <>
std::span<const Named<Frames>> choicesOf() {
  static constexpr Named<Frames> names[] = {{Frames::surface, "surface"}, {Frames::volume, "volume"}};
  return names;
}

template <>
std::span<const Named<Suggestion>> choicesOf() {
  static constexpr Named<Suggestion> names[] = {{Suggestion::object, "object"},
                                                {Suggestion::contrast, "contrast"}};
  return names;
}

template <>
std::span<const Named<Inside>> choicesOf() {
  static constexpr Named<Inside> names[] = {{Inside::above, "above"}, {Inside::below, "below"}};
  return names;
}

template <>
std::span<const Named<HitMethod>> choicesOf() {
  static constexpr Named<HitMethod> names[] = {{HitMethod::sampled, "sampled"}, {HitMethod::exact, "exact"}};
  return names;
}

template <>
std::span<const Named<Field>> choicesOf() {
  static constexpr Named<Field> names[] = {{Field::trilinear, "trilinear"},
                                           {Field::cubic, "cubic"},
                                           {Field::cubic_interpolating, "cubic_interpolating"}};
  return names;
}

template <>
std::span<const Named<StillField>> choicesOf() {
  static constexpr Named<StillField> names[] = {{StillField::automatic, "auto"},
                                                {StillField::same, "same"},
                                                {StillField::cubic_interpolating, "cubic_interpolating"}};
  return names;
}

template <>
std::span<const Named<Fetch>> choicesOf() {
  static constexpr Named<Fetch> names[] = {{Fetch::fast, "fast"}, {Fetch::exact, "exact"}};
  return names;
}

template <>
std::span<const Named<LookMode>> choicesOf() {
  static const std::vector<Named<LookMode>> names = [] {
    std::vector<Named<LookMode>> list;
    for (const LookInfo& look : looks()) list.push_back({look.mode, look.name});
    return list;
  }();
  return names;
}

template <>
std::span<const Named<Shading>> choicesOf() {
  static constexpr Named<Shading> names[] = {{Shading::unlit, "unlit"},
                                             {Shading::lambert, "lambert"},
                                             {Shading::blinn_phong, "blinn_phong"},
                                             {Shading::tone, "tone"},
                                             {Shading::gi, "gi"}};
  return names;
}

template <>
std::span<const Named<SolidTexture>> choicesOf() {
  static constexpr Named<SolidTexture> names[] = {{SolidTexture::none, "none"},
                                                  {SolidTexture::marble, "marble"},
                                                  {SolidTexture::wood, "wood"},
                                                  {SolidTexture::checker, "checker"}};
  return names;
}

template <>
std::span<const Named<ColorMap>> choicesOf() {
  static constexpr Named<ColorMap> names[] = {{ColorMap::automatic, "auto"},
                                              {ColorMap::viridis, "viridis"},
                                              {ColorMap::cividis, "cividis"},
                                              {ColorMap::inferno, "inferno"},
                                              {ColorMap::gray, "gray"},
                                              {ColorMap::coolwarm, "coolwarm"},
                                              {ColorMap::blue_orange, "blue_orange"},
                                              {ColorMap::purple_green, "purple_green"},
                                              {ColorMap::spectral, "spectral"}};
  return names;
}

template <>
std::span<const Named<LengthUnit>> choicesOf() {
  static constexpr Named<LengthUnit> names[] = {{LengthUnit::pixels, "pixels"}, {LengthUnit::mm, "mm"}};
  return names;
}

template <>
std::span<const Named<LegendCorner>> choicesOf() {
  static constexpr Named<LegendCorner> names[] = {{LegendCorner::automatic, "auto"},
                                                  {LegendCorner::lower_right, "lower_right"},
                                                  {LegendCorner::lower_left, "lower_left"},
                                                  {LegendCorner::upper_right, "upper_right"},
                                                  {LegendCorner::upper_left, "upper_left"}};
  return names;
}

template <>
std::span<const Named<FlowDirection>> choicesOf() {
  static constexpr Named<FlowDirection> names[] = {{FlowDirection::maximum, "maximum"},
                                                   {FlowDirection::minimum, "minimum"}};
  return names;
}

template <>
std::span<const Named<LightSetup>> choicesOf() {
  static constexpr Named<LightSetup> names[] = {{LightSetup::three_point, "three_point"},
                                                {LightSetup::key, "key"}};
  return names;
}

template <>
std::span<const Named<LightSpace>> choicesOf() {
  static constexpr Named<LightSpace> names[] = {{LightSpace::camera, "camera"}, {LightSpace::world, "world"}};
  return names;
}

template <>
std::span<const Named<AlbedoSource>> choicesOf() {
  static constexpr Named<AlbedoSource> names[] = {{AlbedoSource::color, "color"}, {AlbedoSource::map, "map"}};
  return names;
}

template <>
std::span<const Named<BuiltInLight>> choicesOf() {
  static constexpr Named<BuiltInLight> names[] = {{BuiltInLight::studio, "studio"},
                                                  {BuiltInLight::window, "window"},
                                                  {BuiltInLight::overcast, "overcast"},
                                                  {BuiltInLight::sunset, "sunset"},
                                                  {BuiltInLight::dark_studio, "dark_studio"}};
  return names;
}

template <>
std::span<const Named<ClipCap>> choicesOf() {
  static constexpr Named<ClipCap> names[] = {
      {ClipCap::none, "none"}, {ClipCap::inside, "inside"}, {ClipCap::whole, "whole"}};
  return names;
}
template <>
std::span<const Named<SlabMode>> choicesOf() {
  static constexpr Named<SlabMode> names[] = {
      {SlabMode::mean, "mean"}, {SlabMode::maximum, "maximum"}, {SlabMode::minimum, "minimum"}};
  return names;
}
template <>
std::span<const Named<Convention>> choicesOf() {
  static constexpr Named<Convention> names[] = {{Convention::radiological, "radiological"},
                                                {Convention::neurological, "neurological"}};
  return names;
}
template <>
std::span<const Named<MarkKind>> choicesOf() {
  static constexpr Named<MarkKind> names[] = {
      {MarkKind::point, "point"}, {MarkKind::distance, "distance"}, {MarkKind::path, "path"},
      {MarkKind::angle, "angle"}, {MarkKind::circle, "circle"},     {MarkKind::thickness, "thickness"},
      {MarkKind::piece, "piece"}};
  return names;
}
template <>
std::span<const Named<Metering>> choicesOf() {
  static constexpr Named<Metering> names[] = {
      {Metering::surface, "surface"}, {Metering::lights, "lights"}, {Metering::brightness, "brightness"}};
  return names;
}

template <>
std::span<const Named<ToneCurve>> choicesOf() {
  static constexpr Named<ToneCurve> names[] = {
      {ToneCurve::automatic, "auto"}, {ToneCurve::linear, "linear"}, {ToneCurve::filmic, "filmic"}};
  return names;
}
template <>
std::span<const Named<WorkOverlay>> choicesOf() {
  static constexpr Named<WorkOverlay> names[] = {{WorkOverlay::none, "none"},
                                                 {WorkOverlay::blocks, "blocks"},
                                                 {WorkOverlay::bricks, "bricks"},
                                                 {WorkOverlay::texels, "texels"}};
  return names;
}

template <>
std::span<const Named<LampKind>> choicesOf() {
  static constexpr Named<LampKind> names[] = {
      {LampKind::point, "point"}, {LampKind::directional, "directional"}, {LampKind::sphere, "sphere"}};
  return names;
}

template <>
std::span<const Named<GiMode>> choicesOf() {
  static constexpr Named<GiMode> names[] = {
      {GiMode::automatic, "auto"},    {GiMode::off, "off"},           {GiMode::irradiance, "irradiance"},
      {GiMode::transfer, "transfer"}, {GiMode::vicinity, "vicinity"}, {GiMode::shadow, "shadow"}};
  return names;
}

template <>
std::span<const Named<GiExtent>> choicesOf() {
  static constexpr Named<GiExtent> names[] = {
      {GiExtent::full, "full"}, {GiExtent::band, "band"}, {GiExtent::view, "view"}};
  return names;
}

template <>
std::span<const Named<GiTexels>> choicesOf() {
  static constexpr Named<GiTexels> names[] = {
      {GiTexels::automatic, "auto"}, {GiTexels::own, "own"}, {GiTexels::shown, "shown"}};
  return names;
}

template <>
std::span<const Named<DirectionSequence>> choicesOf() {
  static constexpr Named<DirectionSequence> names[] = {{DirectionSequence::sobol_owen, "sobol_owen"},
                                                       {DirectionSequence::r2, "r2"},
                                                       {DirectionSequence::random, "random"}};
  return names;
}

template <>
std::span<const Named<GiInterpolation>> choicesOf() {
  static constexpr Named<GiInterpolation> names[] = {{GiInterpolation::closest_isovalue, "closest_isovalue"},
                                                     {GiInterpolation::nearest, "nearest"},
                                                     {GiInterpolation::trilinear, "trilinear"},
                                                     {GiInterpolation::tricubic, "tricubic"},
                                                     {GiInterpolation::weighted, "weighted"}};
  return names;
}

template <>
std::span<const Named<GiPrecision>> choicesOf() {
  static constexpr Named<GiPrecision> names[] = {{GiPrecision::r11g11b10, "r11g11b10"},
                                                 {GiPrecision::half, "half"}};
  return names;
}

template <>
std::span<const Named<Projection>> choicesOf() {
  static constexpr Named<Projection> names[] = {{Projection::perspective, "perspective"},
                                                {Projection::orthographic, "orthographic"}};
  return names;
}

template <>
std::span<const Named<MemoryLayout>> choicesOf() {
  static constexpr Named<MemoryLayout> names[] = {
      {MemoryLayout::automatic, "auto"}, {MemoryLayout::whole, "whole"}, {MemoryLayout::bricks, "bricks"}};
  return names;
}

template <>
std::span<const Named<VoxelPlace>> choicesOf() {
  static constexpr Named<VoxelPlace> names[] = {
      {VoxelPlace::automatic, "auto"}, {VoxelPlace::memory, "memory"}, {VoxelPlace::file, "file"}};
  return names;
}

template <>
std::span<const Named<Canvas>> choicesOf() {
  static constexpr Named<Canvas> names[] = {
      {Canvas::automatic, "auto"}, {Canvas::textures, "textures"}, {Canvas::pixels, "pixels"}};
  return names;
}

template <>
std::span<const Named<Executor>> choicesOf() {
  static constexpr Named<Executor> names[] = {
      {Executor::automatic, "auto"}, {Executor::gpu, "gpu"}, {Executor::cpu, "cpu"}};
  return names;
}

}  // namespace isolux::scene
