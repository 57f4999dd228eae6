#include "app/study/study_knobs.h"

#include <cstdlib>
#include <sstream>

#include "base/error.h"
#include "base/suggestion.h"
#include "render/graph/pass.h"
#include "scene/rules/environment.h"
#include "scene/rules/relevance.h"
#include "scene/settings.h"

namespace isolux::app {

namespace {

namespace pass = render::pass;

constexpr std::string_view kThreshold = "near_threshold";
const std::vector<const char*> kFields{"trilinear", "cubic", "cubic_interpolating"};

const Knob* find(const std::string& name) {
  for (const Knob& knob : knobs())
    if (knob.name == name) return &knob;
  return nullptr;
}

scene::Scene resolvedFirstSurface(scene::Scene scene, const scene::VolumeFacts& facts) {
  for (scene::ExtraIsosurface& extra : scene.extraIsosurfaces) extra.shown = false;
  return scene::resolve(std::move(scene), facts);
}

}  // namespace

const std::array<Panel, 2>& panelsOf(const Knob& knob) {
  static const std::array<Panel, 2> hits{Panel{"depth_rms_voxels",
                                               "depth error, RMS, voxels",
                                               {pass::cast, pass::refine},
                                               [](const Errors& errors) { return errors.depthVoxels.rms; }},
                                         Panel{"missed_ppm",
                                               "missed pixels, ppm of the picture",
                                               {pass::cast, pass::refine},
                                               [](const Errors& errors) { return errors.missedPpm(); }}};
  static const std::array<Panel, 2> shape{
      Panel{"normal_rms_degrees",
            "normal error, RMS, degrees",
            {pass::gradient},
            [](const Errors& errors) { return errors.normalDegrees.rms; }},
      Panel{"curvature_median_relative",
            "relative curvature error, median",
            {pass::hessian},
            [](const Errors& errors) { return errors.curvature.median; }}};
  static const std::array<Panel, 2> light{
      Panel{"irradiance_rmse_relative",
            "relative error of irradiance, RMSE",
            {pass::irradiance},
            [](const Errors& errors) { return errors.light.relative(errors.light.rmse); }},
      Panel{"irradiance_99_relative",
            "relative error of irradiance, 99 %",
            {pass::irradiance},
            [](const Errors& errors) { return errors.light.relative(errors.light.most99); }}};
  switch (knob.measure) {
    case Measure::hits:
      return hits;
    case Measure::shape:
      return shape;
    case Measure::light:
      break;
  }
  return light;
}

namespace {

const std::vector<Knob>& surfaceKnobs() {
  static const std::vector<Knob> list{
      {"rate",
       "hit.rate",
       "rate, samples per voxel",
       Measure::hits,
       false,
       true,
       {"0.5", "1", "2", "4", "8", "16"}},
      {"near_factor",
       "hit.near_factor",
       "near factor r1/r0",
       Measure::hits,
       false,
       true,
       {"1", "2", "4", "8", "16"}},
      {"near_threshold",
       "hit.near_threshold",
       "near threshold, times automatic",
       Measure::hits,
       false,
       true,
       {"0", "0.25", "0.5", "1", "2", "4", "8"}},
      {"refinements",
       "hit.refinements",
       "refinement steps",
       Measure::hits,
       false,
       true,
       {"0", "1", "2", "3", "4", "5", "6", "7", "8"}},
      {"method", "hit.method", "hit method", Measure::hits, false, false, {"sampled", "exact"}},
      {"hit_field", "hit.field", "field that is hit", Measure::hits, true, false, kFields},
      {"derivatives_field", "derivatives.field", "field of the derivatives", Measure::shape, true, false,
       kFields},
      {"fetch",
       "derivatives.fetch",
       "fetches of the derivatives",
       Measure::shape,
       false,
       false,
       {"fast", "exact"}},
  };
  return list;
}

// Knobs that share a bake follow one another, and what reads the most texels of it is the last of them.
const std::vector<Knob>& lightKnobs() {
  constexpr Measure light = Measure::light;
  static const std::vector<Knob> list{
      {"samples",
       "gi.samples",
       "paths per texel",
       light,
       false,
       false,
       {"4", "16", "64", "100", "256"},
       Cost::bakeSeconds,
       true},
      {"sequence",
       "gi.sequence",
       "directions",
       light,
       false,
       false,
       {"random", "r2", "sobol_owen"},
       Cost::bakeSeconds},
      {"environment_share",
       "gi.environment_share",
       "part of directions from the environment",
       light,
       false,
       false,
       {"0", "0.25", "0.5", "auto", "0.9"},
       Cost::bakeSeconds},
      {"bounces",
       "gi.bounces",
       "bounces",
       light,
       false,
       false,
       {"0", "1", "2", "4", "8"},
       Cost::bakeSeconds,
       true},
      {"lattice_scale",
       "gi.lattice_scale",
       "texels per voxel and axis",
       light,
       false,
       false,
       {"0.25", "0.5", "1", "2"},
       Cost::bakeSeconds,
       true},
      {"texels",
       "gi.texels",
       "where texels are lit",
       light,
       false,
       false,
       {"own", "auto"},
       Cost::bakeSeconds},
      {"precision",
       "gi.precision",
       "numbers on the graphics card",
       light,
       false,
       false,
       {"r11g11b10", "half"},
       Cost::gpuMegabytes},
      {"interpolation",
       "gi.interpolation",
       "interpolation between texels",
       light,
       false,
       false,
       {"nearest", "closest_isovalue", "trilinear", "weighted", "tricubic"},
       Cost::lookupMilliseconds},
      {"sh_order",
       "gi.sh_order",
       "bands of spherical harmonics",
       light,
       false,
       false,
       {"1", "2", "3", "4", "5", "6", "8"},
       Cost::bakeSeconds,
       true,
       true},
      {"sh_window",
       "gi.sh_window",
       "window of spherical harmonics",
       light,
       false,
       false,
       {"0", "0.25", "0.5", "0.75", "1"},
       Cost::lookupMilliseconds,
       false,
       true},
      {"components",
       "gi.components",
       "components of compressed transfer",
       light,
       false,
       false,
       {"4", "8", "12", "16", "24", "32", "48", "75"},
       Cost::gpuMegabytes,
       true,
       true},
      {"component_bits",
       "gi.component_bits",
       "bits per component, on average",
       light,
       false,
       false,
       {"2", "3", "4", "6", "8"},
       Cost::gpuMegabytes,
       false,
       true},
  };
  return list;
}

std::vector<Knob> allKnobs() {
  std::vector<Knob> list = surfaceKnobs();
  list.insert(list.end(), lightKnobs().begin(), lightKnobs().end());
  return list;
}

}  // namespace

const std::vector<Knob>& knobs() {
  static const std::vector<Knob> list = allKnobs();
  return list;
}

std::vector<Knob> parseKnobs(const std::string& list) {
  if (list.empty()) return knobs();
  std::vector<std::string> known;
  for (const Knob& knob : knobs()) known.emplace_back(knob.name);
  std::vector<Knob> chosen;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const Knob* const knob = find(word);
    if (!knob) {
      const std::string suggestion = base::nearest(word, known);
      std::string reason = "there is no knob \"" + word + '"';
      if (!suggestion.empty()) {
        reason += ", did you mean " + suggestion + '?';
      } else {
        reason += "; there are";
        for (const std::string& name : known) reason += ' ' + name;
      }
      throw base::Error(base::ErrorKind::usage, "", "--knobs", reason);
    }
    chosen.push_back(*knob);
  }
  return chosen;
}

scene::Scene turned(const Knob& knob, const std::string& value, scene::Scene scene,
                    const scene::VolumeFacts& facts) {
  if (knob.sampled) scene.hit.method = scene::HitMethod::sampled;
  if (knob.measure == Measure::light) scene = litScene(knob, std::move(scene));
  if (knob.name != kThreshold) {
    scene::applyAssignment(scene, std::string(knob.setting) + '=' + value);
    return resolvedFirstSurface(std::move(scene), facts);
  }
  scene.hit.nearThreshold.reset();
  scene = resolvedFirstSurface(std::move(scene), facts);
  *scene.hit.nearThreshold *= std::strtod(value.c_str(), nullptr);
  return scene;
}

std::string defaultValue(const Knob& knob) {
  if (knob.name == kThreshold) return "1";
  const scene::Setting& setting = scene::setting(knob.setting);
  for (const char* const value : knob.values) {
    scene::Scene scene;
    scene::applyAssignment(scene, std::string(knob.setting) + '=' + value);
    if (setting.get(scene) == setting.defaultValue()) return value;
  }
  return {};
}

std::string whyWithoutEffect(const Knob& knob, const scene::Scene& scene) {
  if (knob.measure != Measure::light) return {};
  const scene::Scene lit = litScene(knob, scene);
  if (knob.transfer && scene::hasOneColor(scene.light.environment) && scene.gi.mode != scene::GiMode::off)
    return "the sky has one colour, which one number of transfer says";
  return std::string(scene::whyInactive(knob.setting, lit));
}

double effortOf(const Knob& knob, const scene::Scene& scene) {
  if (!whyWithoutEffect(knob, scene).empty()) return 0.01;
  const auto values = static_cast<double>(knob.values.size());
  if (knob.measure != Measure::light) return values;
  return knob.cost == Cost::bakeSeconds ? 6.0 * values : 2.0 * values;
}

scene::Scene litScene(const Knob& knob, scene::Scene scene) {
  scene.look.mode = scene::LookMode::gi;
  scene.hit.method = scene::HitMethod::exact;
  scene.hit.field = scene::Field::trilinear;
  scene.gi.extent = scene::GiExtent::view;
  scene.isosurface.opacity = 1.0;
  if (!knob.transfer || scene.gi.mode == scene::GiMode::off) return scene;
  scene.gi.mode = scene::GiMode::automatic;
  scene.light.environment.moves = true;
  return scene;
}

}  // namespace isolux::app
