#include "app/study_knobs.h"

#include <cstdlib>
#include <sstream>

#include "render/passes.h"
#include "scene/error.h"
#include "scene/settings.h"
#include "scene/suggestion.h"

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
  scene.isosurface2.shown = scene.isosurface3.shown = scene.isosurface4.shown = false;
  return scene::resolve(std::move(scene), facts);
}

}  // namespace

const std::array<Panel, 2>& panelsOf(Measure measure) {
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
  return measure == Measure::hits ? hits : shape;
}

const std::vector<Knob>& knobs() {
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

std::vector<Knob> parseKnobs(const std::string& list) {
  if (list.empty()) return knobs();
  std::vector<std::string> known;
  for (const Knob& knob : knobs()) known.emplace_back(knob.name);
  std::vector<Knob> chosen;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const Knob* const knob = find(word);
    if (!knob) {
      const std::string suggestion = scene::nearest(word, known);
      std::string reason = "there is no knob \"" + word + '"';
      if (!suggestion.empty()) {
        reason += ", did you mean " + suggestion + '?';
      } else {
        reason += "; there are";
        for (const std::string& name : known) reason += ' ' + name;
      }
      throw scene::Error(scene::ErrorKind::usage, "", "--knobs", reason);
    }
    chosen.push_back(*knob);
  }
  return chosen;
}

scene::Scene turned(const Knob& knob, const std::string& value, scene::Scene scene,
                    const scene::VolumeFacts& facts) {
  if (knob.sampled) scene.hit.method = scene::HitMethod::sampled;
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

}  // namespace isolux::app
