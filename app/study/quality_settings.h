// The quality settings that `isolux study` turns: each with the values it takes and what it is judged by.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/study/study_errors.h"
#include "scene/rules/automatic.h"
#include "scene/scene.h"

namespace isolux::app {

// Names what a quality setting trades for time or memory: where the surface is, how it is bent, what noise
// makes of that, how it is lit, how smooth edges of the picture are, or whether the key light throws a
// shadow.
enum class Measure { hits, shape, scale, light, edges, shadow };
// What it costs: the time of passes, or of the whole frame; of light, tracing it, reading it, or keeping it.
enum class Cost { passes, frameMilliseconds, bakeSeconds, lookupMilliseconds, gpuMegabytes };

// An error that is shown against what it costs.
struct Panel {
  const char *key, *label;          // "depth_rms_voxels"; with unit, for tables and plots
  std::vector<const char*> passes;  // render/graph/pass.h; of the cost that is their time
  const char* noun;                 // what is wrong, in sentences: "depth error"
  const char* unit;                 // "voxels", " %"
  double shown;                     // times this in that unit
  double (*error)(const Errors&);
};
struct QualitySetting;
// Returns what a quality setting is plotted by; the first decides which setting reaches an error.
const std::array<Panel, 2>& panelsOf(const QualitySetting& quality);

// Traits: acts on hit.method sampled only; chooses a field: also compared with cubic_interpolating; its
// values are numbers in order, joined by a line in plots; acts on stored transfer: turned where the
// environment moves.
inline constexpr unsigned kSampled = 1, kField = 2, kOrdered = 4, kTransfer = 8;
struct QualitySetting {
  const char* name;     // as in --knobs
  const char* setting;  // its path
  const char* label;    // with unit, for tables and plots
  Measure measure;
  // Of the setting; near_threshold: multiples of the automatic one; derivatives_scale: of the mean spacing.
  std::vector<std::string> values;
  // The value, or comparison, whose picture those of the others are compared with; of the rays per pixel "",
  // which have a picture of their own for that (app/study/picture_study.h).
  const char* reference = "";
  Cost cost = Cost::passes;
  unsigned traits = 0;
  bool field() const { return (traits & kField) != 0; }
  bool sampled() const { return (traits & kSampled) != 0; }
  bool ordered() const { return (traits & kOrdered) != 0; }
  bool transfer() const { return (traits & kTransfer) != 0; }
};
const std::vector<QualitySetting>& qualitySettings();

// A list "rate,method"; empty: all, in the order of qualitySettings(). Throws Error{usage} with the nearest
// name.
std::vector<QualitySetting> parseQualitySettings(const std::string& list);

// The scene with the quality setting at one value. `scene` as the user gave it: what is automatic follows the
// quality setting. Resolved, and with the first isosurface only; for quality settings of light, litScene().
scene::Scene turned(const QualitySetting& quality, const std::string& value, scene::Scene scene,
                    const scene::VolumeFacts& facts);

// The one of its values that the default scene has; "" for none.
std::string defaultValue(const QualitySetting& quality);

inline constexpr const char* kExactHits = "exact hits";

// Why a quality setting of light, shadow or fetches has no effect in this scene, resolved where its scales
// count, as one clause; "" where it has, and for others.
std::string whyWithoutEffect(const QualitySetting& quality, const scene::Scene& scene);
// How long studying it takes, roughly, in arbitrary units: parts of a progress bar.
double effortOf(const QualitySetting& quality, const scene::Scene& scene);
// The scene whose light the quality setting is judged by: lit by all there is, exact hits of the trilinear
// field, only what is seen is baked.
scene::Scene litScene(const QualitySetting& quality, scene::Scene scene);

}  // namespace isolux::app
