// The quality knobs that `isolux study` turns: each with the values it takes and what it is judged by.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/study_errors.h"
#include "scene/automatic.h"
#include "scene/scene.h"

namespace isolux::app {

// What a knob trades for time: where the surface is, or how it is bent.
enum class Measure { hits, shape };

// An error that is shown against the time of the passes that make it.
struct Panel {
  const char *key, *label;          // "depth_rms_voxels"; with unit, for tables and plots
  std::vector<const char*> passes;  // render/passes.h
  double (*error)(const Errors&);
};
// What knobs of a measure are plotted by; the first decides which setting reaches an error.
const std::array<Panel, 2>& panelsOf(Measure measure);

struct Knob {
  const char* name;     // as in --knobs
  const char* setting;  // its path
  const char* label;    // with unit, for tables and plots
  Measure measure;
  bool field;                       // it chooses a field: also compared with cubic_interpolating
  bool sampled;                     // acts on hit.method sampled only
  std::vector<const char*> values;  // of the setting; near_threshold: multiples of the automatic one
};
const std::vector<Knob>& knobs();

// A list "rate,method"; empty: all, in the order of knobs(). Throws Error{usage} with the nearest name.
std::vector<Knob> parseKnobs(const std::string& list);

// The scene with the knob at one value. `scene` as the user gave it: what is automatic follows the knob.
// Resolved, and with the first isosurface only.
scene::Scene turned(const Knob& knob, const std::string& value, scene::Scene scene,
                    const scene::VolumeFacts& facts);

// The one of its values that the default scene has; "" for none.
std::string defaultValue(const Knob& knob);

}  // namespace isolux::app
